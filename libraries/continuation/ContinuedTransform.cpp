#include "continuation/ContinuedTransform.hpp"

#include <algorithm>
#include <cassert>

namespace isph
{

namespace
{

/// Lines of a batch: two cache lines side by side along the slower axes.
constexpr std::size_t largestBatch = 16;

int batchOf(const LineLayout& layout) { return static_cast<int>(std::min(largestBatch, layout.lines())); }

int lengthOf(const LineLayout& layout, const std::optional<LineContinuation>& continuation)
{
    return continuation ? continuation->extendedPoints() : static_cast<int>(layout.count);
}

} // namespace

ContinuedTransform::ContinuedTransform(const LineLayout& layout, std::optional<LineContinuation> continuation,
                                       double dataScale, PlanEffort effort)
    : layout_(layout),
      continuation_(std::move(continuation)),
      dataScale_(dataScale),
      transform_(lengthOf(layout, continuation_), batchOf(layout), effort),
      lines_(transform_.realLines()),
      modes_(transform_.modesOfLines()),
      result_(transform_.modesOfLines())
{
    assert(!continuation_ || continuation_->points() == static_cast<int>(layout.count));
}

std::size_t ContinuedTransform::batches() const
{
    const auto batch = static_cast<std::size_t>(transform_.lines());
    return (layout_.lines() + batch - 1) / batch;
}

const RealField& ContinuedTransform::extended(std::size_t batch, std::span<const double> values, const EndData& data)
{
    assert(values.size() == layout_.points());
    const std::size_t first = batch * static_cast<std::size_t>(transform_.lines());
    gatherLines(values, layout_, first, lines_);
    if (!continuation_) { return lines_; }
    const std::size_t last = std::min(first + static_cast<std::size_t>(transform_.lines()), layout_.lines());
    for (std::size_t line = first; line < last; ++line)
    {
        continuation_->extend(lines_[static_cast<int>(line - first)],
                              data.lower.empty() ? 0 : dataScale_ * data.lower[line],
                              data.upper.empty() ? 0 : dataScale_ * data.upper[line]);
    }
    return lines_;
}

const SpectralField& ContinuedTransform::forward(std::size_t batch, std::span<const double> values, const EndData& data)
{
    extended(batch, values, data);
    transform_.forward(lines_, modes_);
    return modes_;
}

void ContinuedTransform::backward(std::size_t batch, std::span<double> values)
{
    transform_.backward(result_, lines_);
    scatterLines(lines_, layout_, batch * static_cast<std::size_t>(transform_.lines()), values);
}

} // namespace isph
