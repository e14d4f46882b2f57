#include "spectral/RealTransform.hpp"

#include "core/Error.hpp"
#include "spectral/FftwPlan.hpp"
#include "spectral/PairedTransform.hpp"
#include "spectral/SplitRadix.hpp"
#include "spectral/wisdom.hpp"

#include <algorithm>
#include <cassert>
#include <omp.h>
#include <optional>
#include <vector>

namespace isph
{

namespace
{

constexpr std::size_t lanes = SplitRadix::lanes;

/// Where the samples of lines, values or modes, lie in the rows that are transformed, and their signs there.
struct Places
{
    std::vector<std::size_t> row;
    std::vector<double> sign;
};

bool hasPointsOnEnds(RealBasis basis) { return basis == RealBasis::cosine1 || basis == RealBasis::sine1; }
bool isPackaged(RealBasis basis) { return basis == RealBasis::cosine4 || basis == RealBasis::sine4; }

PairedTransform::Kind kindOf(RealBasis basis)
{
    switch (basis)
    {
    case RealBasis::cosine2:
    case RealBasis::cosine3:
        return PairedTransform::Kind::cosine2;
    case RealBasis::sine2:
    case RealBasis::sine3:
        return PairedTransform::Kind::sine2;
    default:
        return PairedTransform::Kind::fourier;
    }
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

/// Lines that are transformed together, as they lie in the array.
struct Block
{
    double* start;
    std::size_t count;    ///< values of a line
    std::size_t stride;   ///< from a value of a line to the next
    std::size_t fromLine; ///< from a line to the next
    std::size_t width;    ///< lines
};

/// Calls move(value in the array, its place among the rows, its sign) for all values, row by row.
template<class Move>
void forValues(const Block& block, const Places& places, double* rows, Move move)
{
    for (std::size_t j = 0; j < block.count; ++j)
    {
        double* array = block.start + j * block.stride;
        double* row = rows + places.row[j];
        const double sign = places.sign[j];
        // Loops of known length, and of known stride where lines lie side by side, are several times as fast.
        if (block.width < lanes)
        {
            for (std::size_t c = 0; c < block.width; ++c) { move(array[c * block.fromLine], row[c], sign); }
        }
        else if (block.fromLine == 1)
        {
            for (std::size_t c = 0; c < lanes; ++c) { move(array[c], row[c], sign); }
        }
        else
        {
            for (std::size_t c = 0; c < lanes; ++c) { move(array[c * block.fromLine], row[c], sign); }
        }
    }
}

} // namespace

struct RealTransform::Plans
{
    Lines lines;
    RealBasis basis;
    double factor;
    std::size_t stride = 1; ///< from a value of a line to the next
    std::size_t inner = 1;  ///< lines that lie side by side
    std::size_t outer = 1;  ///< groups of such lines

    // One of these does both directions.
    std::optional<SplitRadix> split;
    std::optional<PairedTransform> paired;
    FftwPlan packaged;

    Places values;
    Places modes;
    std::size_t rowsOfThread = 0;
    std::size_t scratchOfThread = 0; ///< rows and what the transform needs besides
    mutable AlignedVector<double> scratch;

    std::size_t axis() const { return static_cast<std::size_t>(lines.axis); }
    std::size_t count() const { return static_cast<std::size_t>(lines.count); }
    std::size_t length() const { return stride * static_cast<std::size_t>(lines.extents[axis()]); }
    std::size_t size() const { return length() * outer; }

    void plan(unsigned rigor);
    bool planned() const { return packaged || (split && split->planned()) || (paired && paired->planned()); }
    void place();
    void transform(std::span<double> array, bool forwards) const;
    double* transformRows(bool analyse, double* rows) const; ///< \return where the result is
};

void RealTransform::Plans::plan(unsigned rigor)
{
    if (hasPointsOnEnds(basis))
    {
        const bool even = basis == RealBasis::cosine1;
        const std::size_t intervals = even ? count() - 1 : count() + 1;
        split.emplace(intervals, even ? SplitRadix::Parity::even : SplitRadix::Parity::odd, rigor);
        rowsOfThread = (intervals + 1) * lanes;
        scratchOfThread = rowsOfThread + split->scratchSize();
        return;
    }
    if (!isPackaged(basis))
    {
        paired.emplace(count(), kindOf(basis), rigor);
        rowsOfThread = count() * lanes;
        scratchOfThread = 2 * rowsOfThread;
        return;
    }
    AlignedVector<double> array(size());
    const fftw_r2r_kind kind = basis == RealBasis::cosine4 ? FFTW_REDFT11 : FFTW_RODFT11;
    const int step = static_cast<int>(stride);
    const fftw_iodim line{lines.count, step, step};
    const int group = static_cast<int>(length());
    const std::array<fftw_iodim, 2> others{{{static_cast<int>(outer), group, group}, {static_cast<int>(inner), 1, 1}}};
    double* start = array.data() + static_cast<std::size_t>(lines.first) * stride;
    packaged.reset(fftw_plan_guru_r2r(1, &line, 2, others.data(), start, start, &kind, rigor));
}

void RealTransform::Plans::place()
{
    for (std::size_t j = 0; j < count(); ++j)
    {
        // A DST-I has its first sample in row 1.
        const std::size_t plain = basis == RealBasis::sine1 ? j + 1 : j;
        values.row.push_back(lanes * (paired ? paired->valueRow(j) : plain));
        values.sign.push_back(paired ? paired->valueSign(j) : 1);
        modes.row.push_back(lanes * (paired ? paired->modeRow(j) : plain));
        modes.sign.push_back(1);
    }
}

RealTransform::RealTransform(const Lines& lines, RealBasis basis, PlanEffort effort) : plans_(std::make_unique<Plans>())
{
    if (lines.count < (basis == RealBasis::cosine1 ? 2 : 1))
    {
        throw Error(Fault::input, "a transform needs more points on its axis", "give the axis at least three");
    }
    plans_->lines = lines;
    plans_->basis = basis;
    plans_->factor = factorOf(basis, lines.count);
    for (std::size_t d = 0; d < 3; ++d)
    {
        const auto extent = static_cast<std::size_t>(lines.extents[d]);
        if (d < plans_->axis()) { plans_->stride *= extent; }
        if (d > plans_->axis()) { plans_->outer *= extent; }
    }
    plans_->inner = plans_->stride;

    // Few values are sooner transformed than shared out.
    constexpr std::size_t worthSharing = 32768;
    const int threads = plans_->size() < worthSharing ? 1 : omp_get_max_threads();
    withPlanner(isPackaged(basis) ? threads : 1,
                [&]
                {
                    const auto plan = [&](unsigned rigor) { plans_->plan(rigor); };
                    const bool kept = effort == PlanEffort::measured && withWisdom([&plan] { plan(FFTW_MEASURE); });
                    if (!kept) { plan(FFTW_ESTIMATE); }
                });
    if (!plans_->planned()) { throw Error(Fault::input, "FFTW found no plan for these lines"); }
    plans_->place();
    plans_->scratch.resize(plans_->scratchOfThread * static_cast<std::size_t>(threads));
}

RealTransform::~RealTransform() = default;
RealTransform::RealTransform(RealTransform&&) noexcept = default;
RealTransform& RealTransform::operator=(RealTransform&&) noexcept = default;

double* RealTransform::Plans::transformRows(bool analyse, double* rows) const
{
    double* others = rows + rowsOfThread;
    if (split)
    {
        split->transform(rows, others);
        return rows;
    }
    if (analyse) { paired->analyse(rows, others); }
    else { paired->synthesise(rows, others); }
    return others;
}

void RealTransform::Plans::transform(std::span<double> array, bool forwards) const
{
    assert(array.size() == size());
    double* const first = array.data() + static_cast<std::size_t>(lines.first) * stride;
    if (packaged)
    {
        fftw_execute_r2r(packaged.get(), first, first);
        return;
    }
    // Types III are the syntheses of types II.
    const bool analyse = forwards != (basis == RealBasis::cosine3 || basis == RealBasis::sine3);
    const Places& in = analyse ? values : modes;
    const Places& out = analyse ? modes : values;

    // Lines that lie side by side are gathered row by row; along x it is whole lines that do.
    const bool sideBySide = stride > 1;
    const std::size_t groups = sideBySide ? outer : 1;
    const std::size_t linesOfGroup = sideBySide ? inner : outer;
    const std::size_t fromLine = sideBySide ? 1 : length();
    const std::size_t blocks = (linesOfGroup + lanes - 1) / lanes;
    const int threads = static_cast<int>(scratch.size() / scratchOfThread);

    const auto transformBlock = [&](std::size_t b, double* rows)
    {
        const std::size_t line = b % blocks * lanes;
        const std::size_t width = std::min(lanes, linesOfGroup - line);
        const Block block{first + b / blocks * length() + line * fromLine, count(), stride, fromLine, width};
        // A line alone shares its transform with zeros, not with what another block left behind.
        if (width < lanes) { std::fill_n(rows, rowsOfThread, 0.0); }
        forValues(block, in, rows, [](const double& value, double& row, double sign) { row = sign * value; });
        double* result = transformRows(analyse, rows);
        forValues(block, out, result, [](double& value, const double& row, double sign) { value = sign * row; });
    };

    // A team of one thread would still be allocated.
    if (threads == 1)
    {
        for (std::size_t b = 0; b < groups * blocks; ++b) { transformBlock(b, scratch.data()); }
        return;
    }
#pragma omp parallel for num_threads(threads)
    for (std::size_t b = 0; b < groups * blocks; ++b)
    {
        transformBlock(b, scratch.data() + static_cast<std::size_t>(omp_get_thread_num()) * scratchOfThread);
    }
}

void RealTransform::forward(std::span<double> values) const { plans_->transform(values, true); }
void RealTransform::backward(std::span<double> values) const { plans_->transform(values, false); }

double RealTransform::factor() const { return plans_->factor; }

} // namespace isph
