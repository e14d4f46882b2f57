#pragma once

#include "continuation/LineContinuation.hpp"
#include "continuation/LineLayout.hpp"
#include "spectral/LineTransform.hpp"

#include <concepts>
#include <optional>

namespace isph
{

/// What is given at the walls, a value for each line of an axis: the outward derivative [1/m] under Neumann conditions,
/// on staggered lines the wall value under Dirichlet conditions. Empty: zero, or not needed.
struct EndData
{
    std::span<const double> lower = {};
    std::span<const double> upper = {};
};

/// The real Fourier transform along one axis of a field whose lines are made periodic as they are gathered.
///
/// Works batch by batch: a batch of lines, their new points and their modes stay in the processor's cache, and the
/// extended field is never held as a whole.
class ContinuedTransform
{
public:
    /// \param continuation none: the lines are periodic as they are
    /// \param dataScale factor from the wall data to those of EndCondition: the spacing for outward derivatives
    ContinuedTransform(const LineLayout& layout, std::optional<LineContinuation> continuation, double dataScale = 1,
                       PlanEffort effort = PlanEffort::estimated);

    const LineLayout& layout() const { return layout_; }
    int length() const { return transform_.length(); } ///< points of an extended line
    std::size_t batches() const;

    /// Modes of a batch: a component for each line, length()/2 + 1 values. Valid until the next call.
    const SpectralField& forward(std::size_t batch, std::span<const double> values, const EndData& data = {});

    /// The modes that backward takes, to be filled.
    SpectralField& result() { return result_; }

    /// Puts the lines whose modes are in result(), times length(), into values; new points are dropped.
    void backward(std::size_t batch, std::span<double> values);

    /// The same, handing each point and its value to visit(point, value).
    template<class Visit>
    void backward(std::size_t batch, Visit visit)
        requires std::invocable<Visit, std::size_t, double>
    {
        transform_.backward(result_, lines_);
        const double* from = lines_.data();
        forEachPoint(layout_, batch * static_cast<std::size_t>(transform_.lines()), lines_.stride(),
                     static_cast<std::size_t>(lines_.components()),
                     [from, &visit](std::size_t point, std::size_t place) { visit(point, from[place]); });
    }

    /// The extended lines of a batch themselves. Valid until the next call.
    const RealField& extended(std::size_t batch, std::span<const double> values, const EndData& data = {});

private:
    LineLayout layout_;
    std::optional<LineContinuation> continuation_;
    double dataScale_;
    LineTransform transform_;
    RealField lines_;
    SpectralField modes_;
    SpectralField result_;
};

} // namespace isph
