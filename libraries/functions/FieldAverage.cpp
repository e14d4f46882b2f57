#include "functions/FieldAverage.hpp"

#include "case/AtomicFolder.hpp"
#include "core/Error.hpp"
#include "fieldStore/FieldReader.hpp"
#include "fieldStore/FieldWriter.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <utility>

namespace isph
{

namespace
{

/// "m/s" squared is "m2/s2": exponents, at most 2 in the units of a flow, double.
std::string squared(const std::string& unit)
{
    std::string result;
    for (std::size_t i = 0; i < unit.size(); ++i)
    {
        if (unit[i] == '2') { result += '4'; }
        else { result += unit[i]; }
        const bool endsName = i + 1 == unit.size() || unit[i + 1] == '/';
        if (endsName && std::isalpha(static_cast<unsigned char>(unit[i])) != 0) { result += '2'; }
    }
    return result;
}

/// The state that averages go on from: how long they have been gathered, and when the last sample was taken.
std::string stateName(const std::string& field) { return field + "Average"; }

RealField copyOfComponent(const RealField& field, int component)
{
    RealField copy(1, field.size());
    std::ranges::copy(field[component], copy[0].begin());
    return copy;
}

} // namespace

FieldAverage::FieldAverage(std::filesystem::path folder, std::string startTime, const Lattice& lattice,
                           FlowFields fields, std::vector<FlowQuantity> quantities, bool moments)
    : folder_(std::move(folder)),
      startTime_(std::move(startTime)),
      lattice_(lattice),
      fields_(std::move(fields)),
      quantities_(std::move(quantities)),
      moments_(moments)
{
}

void FieldAverage::begin()
{
    for (const FlowQuantity quantity : quantities_)
    {
        const int components = fields_.components(quantity);
        averages_.push_back(
            {.name = std::string(flowQuantities().nameOf(quantity)),
             .unit = fields_.unit(quantity),
             .mean = RealField(components, lattice_.points()),
             .moments = RealField(moments_ ? components * (components + 1) / 2 : 0, lattice_.points())});
    }
    removeLeftovers(folder_);
    const std::filesystem::path file = folder_ / startTime_ / "fields.h5";
    if (std::filesystem::exists(file)) { restore(file); }
}

void FieldAverage::restore(const std::filesystem::path& file)
{
    const FieldReader reader(file);
    if (reader.lattice() != Lattice({lattice_.axis(0), lattice_.axis(1), lattice_.axis(2)}, {}))
    {
        throw Error(Fault::input, {file.string(), 0, ""}, "holds averages on another lattice",
                    "remove that folder to average from the start");
    }
    for (Average& average : averages_)
    {
        const bool hasMoments = !moments_ || reader.has(momentName(average, 0, 0));
        if (!reader.hasState(stateName(average.name)) || !hasMoments) { continue; } // not averaged until now
        RealField state(1, 2);
        reader.readState(stateName(average.name), state);
        average.duration = state[0][0];
        last_ = state[0][1];
        average.mean = reader.read(average.name + "Mean");
        int moment = 0;
        for (int a = 0; moments_ && a < average.mean.components(); ++a)
        {
            for (int b = a; b < average.mean.components(); ++b)
            {
                const RealField stored = reader.read(momentName(average, a, b));
                std::ranges::copy(stored[0], average.moments[moment++].begin());
            }
        }
    }
}

void FieldAverage::accumulate(const FlowAtTime& now)
{
    if (averages_.empty())
    {
        // The first sample starts the clock. After a restart it is one that the run before took, or did not take.
        begin();
        if (!last_) { last_ = now.time; }
        return;
    }
    const double weight = now.time - *last_;
    if (!(weight > 0)) { return; }
    last_ = now.time;

    const std::vector<NamedField> fields = fields_.at(now, quantities_);
    for (std::size_t i = 0; i < fields.size(); ++i)
    {
        Average& average = averages_[i];
        const RealField& sample = fields[i].values;
        const double part = weight / (average.duration + weight);
        const double rest = average.duration / (average.duration + weight);
        average.duration += weight;

        // Moments first: they need the distance to the old mean.
        int moment = 0;
        for (int a = 0; moments_ && a < sample.components(); ++a)
        {
            for (int b = a; b < sample.components(); ++b)
            {
                const auto u = sample[a];
                const auto v = sample[b];
                const std::span<const double> uMean = std::as_const(average.mean)[a];
                const std::span<const double> vMean = std::as_const(average.mean)[b];
                const std::span<double> moments = average.moments[moment++];
                for (std::size_t n = 0; n < moments.size(); ++n)
                {
                    moments[n] = rest * (moments[n] + part * (u[n] - uMean[n]) * (v[n] - vMean[n]));
                }
            }
        }
        for (int c = 0; c < sample.components(); ++c)
        {
            const auto u = sample[c];
            const std::span<double> mean = average.mean[c];
            for (std::size_t n = 0; n < mean.size(); ++n) { mean[n] += part * (u[n] - mean[n]); }
        }
    }
}

void FieldAverage::execute(const FlowAtTime& now)
{
    const bool gathered = std::ranges::any_of(averages_, [](const Average& average) { return average.duration > 0; });
    if (!gathered) { return; }
    AtomicFolder folder(folder_ / now.name);
    FieldWriter writer(folder.path() / "fields.h5", lattice_);
    for (const Average& average : averages_)
    {
        writer.write(average.name + "Mean", average.unit, average.mean);
        int moment = 0;
        for (int a = 0; moments_ && a < average.mean.components(); ++a)
        {
            for (int b = a; b < average.mean.components(); ++b)
            {
                writer.write(momentName(average, a, b), squared(average.unit),
                             copyOfComponent(average.moments, moment++));
            }
        }
        RealField state(1, 2);
        state[0][0] = average.duration;
        state[0][1] = *last_;
        writer.writeState(stateName(average.name), state);
    }
    writer.close();
    folder.commit();
}

std::string FieldAverage::momentName(const Average& average, int a, int b) const
{
    if (average.mean.components() == 1) { return average.name + "Prime2Mean"; }
    return fmt::format("{}Prime2Mean.{}{}", average.name, lattice_.activeAxis(a).name, lattice_.activeAxis(b).name);
}

} // namespace isph
