#include "spectral/RealTransform.hpp"

#include "core/Error.hpp"
#include "spectral/FftwPlan.hpp"
#include "spectral/SplitRadix.hpp"
#include "spectral/wisdom.hpp"

#include <algorithm>
#include <cassert>
#include <omp.h>
#include <optional>

namespace isph
{

namespace
{

constexpr std::size_t lanes = SplitRadix::lanes;

std::array<fftw_r2r_kind, 2> kindsOf(RealBasis basis)
{
    switch (basis)
    {
    case RealBasis::cosine1:
        return {FFTW_REDFT00, FFTW_REDFT00};
    case RealBasis::cosine2:
        return {FFTW_REDFT10, FFTW_REDFT01};
    case RealBasis::cosine3:
        return {FFTW_REDFT01, FFTW_REDFT10};
    case RealBasis::cosine4:
        return {FFTW_REDFT11, FFTW_REDFT11};
    case RealBasis::sine1:
        return {FFTW_RODFT00, FFTW_RODFT00};
    case RealBasis::sine2:
        return {FFTW_RODFT10, FFTW_RODFT01};
    case RealBasis::sine3:
        return {FFTW_RODFT01, FFTW_RODFT10};
    case RealBasis::sine4:
        return {FFTW_RODFT11, FFTW_RODFT11};
    case RealBasis::fourier:
        break;
    }
    return {FFTW_R2HC, FFTW_HC2R};
}

double factorOf(RealBasis basis, double n)
{
    switch (basis)
    {
    case RealBasis::fourier:
        return n;
    case RealBasis::cosine1:
        return 2 * (n - 1);
    case RealBasis::sine1:
        return 2 * (n + 1);
    default:
        return 2 * n;
    }
}

} // namespace

struct RealTransform::Plans
{
    Lines lines;
    double factor;
    std::size_t stride = 1; ///< from a value of a line to the next
    std::size_t inner = 1;  ///< lines that lie side by side
    std::size_t outer = 1;  ///< groups of such lines
    FftwPlan forward;
    FftwPlan backward;
    std::optional<SplitRadix> split; ///< instead of both
    std::size_t scratchOfThread = 0;
    mutable AlignedVector<double> scratch;

    std::size_t size() const { return inner * outer * static_cast<std::size_t>(lines.extents[axis()]); }
    std::size_t axis() const { return static_cast<std::size_t>(lines.axis); }

    void plan(RealBasis basis, unsigned rigor);
    void execute(const FftwPlan& plan, std::span<double> values) const;
    void transformSplit(std::span<double> values) const;
};

void RealTransform::Plans::plan(RealBasis basis, unsigned rigor)
{
    if (basis == RealBasis::cosine1 || basis == RealBasis::sine1)
    {
        const bool even = basis == RealBasis::cosine1;
        const auto intervals = static_cast<std::size_t>(even ? lines.count - 1 : lines.count + 1);
        split.emplace(intervals, even ? SplitRadix::Parity::even : SplitRadix::Parity::odd, rigor);
        scratchOfThread = split->scratchSize() + (intervals + 1) * lanes;
        return;
    }
    AlignedVector<double> values(size());
    const auto [there, back] = kindsOf(basis);
    const int step = static_cast<int>(stride);
    const fftw_iodim line{lines.count, step, step};
    const int group = step * lines.extents[axis()];
    const std::array<fftw_iodim, 2> others{{{static_cast<int>(outer), group, group}, {static_cast<int>(inner), 1, 1}}};
    double* start = values.data() + static_cast<std::size_t>(lines.first) * stride;
    forward.reset(fftw_plan_guru_r2r(1, &line, 2, others.data(), start, start, &there, rigor));
    backward.reset(fftw_plan_guru_r2r(1, &line, 2, others.data(), start, start, &back, rigor));
}

RealTransform::RealTransform(const Lines& lines, RealBasis basis, PlanEffort effort) : plans_(std::make_unique<Plans>())
{
    if (lines.count < (basis == RealBasis::cosine1 ? 2 : 1))
    {
        throw Error(Fault::input, "a transform needs more points on its axis", "give the axis at least three");
    }
    plans_->lines = lines;
    plans_->factor = factorOf(basis, lines.count);
    for (std::size_t d = 0; d < 3; ++d)
    {
        const auto extent = static_cast<std::size_t>(lines.extents[d]);
        if (d < plans_->axis()) { plans_->stride *= extent; }
        if (d > plans_->axis()) { plans_->outer *= extent; }
    }
    plans_->inner = plans_->stride;

    const int threads = omp_get_max_threads();
    const bool split = basis == RealBasis::cosine1 || basis == RealBasis::sine1;
    withPlanner(split ? 1 : threads,
                [&]
                {
                    const auto plan = [&](unsigned rigor) { plans_->plan(basis, rigor); };
                    const bool kept = effort == PlanEffort::measured && withWisdom([&plan] { plan(FFTW_MEASURE); });
                    if (!kept) { plan(FFTW_ESTIMATE); }
                });
    if (split ? !plans_->split->planned() : !plans_->forward || !plans_->backward)
    {
        throw Error(Fault::input, "FFTW found no plan for these lines");
    }
    plans_->scratch.resize(plans_->scratchOfThread * static_cast<std::size_t>(threads));
}

RealTransform::~RealTransform() = default;
RealTransform::RealTransform(RealTransform&&) noexcept = default;
RealTransform& RealTransform::operator=(RealTransform&&) noexcept = default;

void RealTransform::Plans::execute(const FftwPlan& plan, std::span<double> values) const
{
    double* start = values.data() + static_cast<std::size_t>(lines.first) * stride;
    fftw_execute_r2r(plan.get(), start, start);
}

void RealTransform::Plans::transformSplit(std::span<double> values) const
{
    const auto count = static_cast<std::size_t>(lines.count);
    const std::size_t length = stride * static_cast<std::size_t>(lines.extents[axis()]);
    // Lines that lie side by side are gathered row by row; along x it is whole lines that do.
    const bool sideBySide = stride > 1;
    const std::size_t groups = sideBySide ? outer : 1;
    const std::size_t linesOfGroup = sideBySide ? inner : outer;
    const std::size_t fromLine = sideBySide ? 1 : length;
    const std::size_t blocks = (linesOfGroup + lanes - 1) / lanes;
    const std::size_t intervals = scratchOfThread - split->scratchSize();
    const int threads = static_cast<int>(scratch.size() / scratchOfThread);
    // A DST-I has its first sample in row 1.
    const std::size_t firstRow = intervals / lanes == count ? 0 : 1;

#pragma omp parallel for num_threads(threads) if (threads > 1)
    for (std::size_t b = 0; b < groups * blocks; ++b)
    {
        double* rows = scratch.data() + static_cast<std::size_t>(omp_get_thread_num()) * scratchOfThread;
        double* work = rows + intervals;
        const std::size_t line = b % blocks * lanes;
        const std::size_t width = std::min(lanes, linesOfGroup - line);
        double* start =
            values.data() + b / blocks * length + line * fromLine + static_cast<std::size_t>(lines.first) * stride;
        for (std::size_t j = 0; j < count; ++j)
        {
            double* row = rows + (j + firstRow) * lanes;
            const double* from = start + j * stride;
            for (std::size_t c = 0; c < width; ++c) { row[c] = from[c * fromLine]; }
            // A line alone shares its transform with zeros, not with what another block left behind.
            for (std::size_t c = width; c < lanes; ++c) { row[c] = 0; }
        }
        split->transform(rows, work);
        for (std::size_t j = 0; j < count; ++j)
        {
            const double* row = rows + (j + firstRow) * lanes;
            double* to = start + j * stride;
            for (std::size_t c = 0; c < width; ++c) { to[c * fromLine] = row[c]; }
        }
    }
}

void RealTransform::forward(std::span<double> values) const
{
    assert(values.size() == plans_->size());
    plans_->split ? plans_->transformSplit(values) : plans_->execute(plans_->forward, values);
}

void RealTransform::backward(std::span<double> values) const
{
    assert(values.size() == plans_->size());
    plans_->split ? plans_->transformSplit(values) : plans_->execute(plans_->backward, values);
}

double RealTransform::factor() const { return plans_->factor; }

} // namespace isph
