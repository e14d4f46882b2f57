#pragma once

#include "continuation/Continuation.hpp"

#include <span>

namespace isph
{

/// A continuation ready for lines of n points: the blocks of both ends as they are applied.
class LineContinuation
{
public:
    /// \throws Error(input) without origin if a line has fewer points than the continuation uses.
    LineContinuation(const Continuation& continuation, int n, EndCondition lower = EndCondition::dirichlet,
                     EndCondition upper = EndCondition::dirichlet);

    int points() const { return points_; }
    int newPoints() const { return newPoints_; }
    int extendedPoints() const { return points_ + newPoints_; }

    /// Fills the new points of a line; its first points() values are given.
    /// \param line of extendedPoints() values
    /// \param lowerDatum, upperDatum see EndCondition; not looked at where an end has no datum
    void extend(std::span<double> line, double lowerDatum = 0, double upperDatum = 0) const;

private:
    /// A block with one contiguous column of new points for each point and one for the datum.
    struct End
    {
        End(const EndBlock& block, bool reversed);

        std::vector<double> columns;
        std::vector<double> data;
        int points;
    };

    int points_;
    int newPoints_;
    End lower_;
    End upper_;
};

} // namespace isph
