#include "caseFields/StreamFunction.hpp"

#include "caseFields/VelocityDerivatives.hpp"
#include "fields/reductions.hpp"
#include "lattice/LatticeFace.hpp"
#include "lattice/Quadrature.hpp"
#include "poisson/BoundedPoisson.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace isph
{

namespace
{

double mean(std::span<const double> values) { return sum(values) / static_cast<double>(values.size()); }

/// The two faces of a bounded axis, with values at their points.
struct FacePair
{
    FacePair(const Lattice& lattice, int direction)
        : faces{LatticeFace(lattice, direction, false), LatticeFace(lattice, direction, true)}
    {
    }

    std::array<std::vector<double>, 2> valuesOf(std::span<const double> field) const
    {
        std::array<std::vector<double>, 2> values;
        for (std::size_t side = 0; side < 2; ++side)
        {
            values[side].resize(faces[side].points());
            faces[side].values(field, values[side]);
        }
        return values;
    }

    /// The velocity through the faces.
    std::array<std::vector<double>, 2> flowThrough(std::span<const double> normalVelocity) const
    {
        std::array<std::vector<double>, 2> flow = valuesOf(normalVelocity);
        for (std::size_t side = 0; side < 2; ++side)
        {
            if (!flowsThrough(faces[side], normalVelocity)) { std::ranges::fill(flow[side], 0.0); }
        }
        return flow;
    }

    std::array<LatticeFace, 2> faces;
};

FaceValues viewOf(const std::array<std::vector<double>, 2>& values) { return {values[0], values[1]}; }

/// Flow through the ends of a plane's axes and what is known of its stream function, active axes a, b = 0, 1.
class Plane
{
public:
    Plane(const RealField& U, const Lattice& lattice)
        : U_(U), lattice_(lattice), derivatives_(lattice), result_{RealField(1, U.size()), {}}
    {
    }

    StreamFunction solve()
    {
        std::array<AxisEnds, 3> ends;
        std::vector<int> bounded;
        for (int d = 0; d < 2; ++d)
        {
            if (lattice_.activeAxis(d).periodic()) { continue; }
            bounded.push_back(d);
            ends[direction(d)] = {End::dirichlet, End::dirichlet};
        }
        RealField source = derivatives_.vorticity(U_);
        for (double& value : source[0]) { value *= -normalSign(lattice_); }

        WallData walls;
        if (bounded.empty())
        {
            for (int d = 0; d < 2; ++d)
            {
                result_.periodGain[direction(d)] = slopeSign(d) * mean(U_[1 - d]) * length(d);
            }
            BoundedPoisson(lattice_, ends).solve(source, walls, result_.values);
        }
        else if (bounded.size() == 1)
        {
            const int normal = bounded.front();
            const FacePair faces(lattice_, lattice_.direction(normal));
            const auto values = valuesOfChannel(normal, faces);
            walls[direction(normal)] = viewOf(values);
            const auto sourceAtWalls = faces.valuesOf(source[0]);
            BoundedPoisson(lattice_, ends).solveClosed(source, walls, viewOf(sourceAtWalls), result_.values);
        }
        else { solveBox(source); }
        addMeanFlow();
        return std::move(result_);
    }

private:
    using SideValues = std::array<std::vector<double>, 2>;

    static std::size_t at(int d) { return static_cast<std::size_t>(d); }
    std::size_t direction(int d) const { return static_cast<std::size_t>(lattice_.direction(d)); }
    double length(int d) const { return lattice_.activeAxis(d).extent; }

    /// dpsi/d(axis d) = slopeSign(d) * the other component.
    static double slopeSign(int d) { return d == 0 ? -1 : 1; }

    /// psi at both walls of a channel, less its growth from period to period, which is left in result_.
    SideValues valuesOfChannel(int normal, const FacePair& faces)
    {
        const int along = 1 - normal;
        const Axis& periodic = lattice_.activeAxis(along);
        SideValues psi = faces.valuesOf(U_[normal]);
        double meanThrough = 0;
        for (std::vector<double>& ofSide : psi)
        {
            const double through = mean(ofSide);
            meanThrough += 0.5 * through;
            for (double& value : ofSide) { value = slopeSign(along) * (value - through); }
            ofSide = runningIntegral(periodic, ofSide);
            ofSide.pop_back();
        }
        result_.periodGain[direction(along)] = slopeSign(along) * meanThrough * periodic.extent;
        const double flux = Quadrature(lattice_).of(U_[along]) / periodic.extent;
        const double step = slopeSign(normal) * flux - mean(psi[1]) + mean(psi[0]);
        for (double& value : psi[1]) { value += step; }
        return psi;
    }

    /// psi along the faces of a box, from their lower end on and last at their upper end.
    std::array<SideValues, 2> valuesOfBox(const std::array<FacePair, 2>& faces) const
    {
        std::array<SideValues, 2> psi; // first the outflow
        double net = 0;
        double through = 0;
        for (int d = 0; d < 2; ++d)
        {
            SideValues& outflow = psi[at(d)];
            outflow = faces[at(d)].flowThrough(U_[d]);
            for (double& value : outflow[0]) { value = -value; }
            for (const std::vector<double>& ofSide : outflow)
            {
                net += runningIntegral(lattice_.activeAxis(1 - d), ofSide).back();
                std::vector<double> magnitudes = ofSide;
                for (double& value : magnitudes) { value = std::abs(value); }
                through += runningIntegral(lattice_.activeAxis(1 - d), magnitudes).back();
            }
        }
        const double excess = through > 0 ? net / through : 0;
        for (int d = 0; d < 2; ++d)
        {
            for (std::size_t side = 0; side < 2; ++side)
            {
                std::vector<double>& ofSide = psi[at(d)][side];
                const double sign = side == 0 ? -slopeSign(1 - d) : slopeSign(1 - d);
                for (double& value : ofSide) { value = sign * (value - excess * std::abs(value)); }
                ofSide = runningIntegral(lattice_.activeAxis(1 - d), ofSide);
            }
        }
        // The upper face of each axis begins where the lower face of the other ends.
        const std::array<double, 2> corner{psi[1][0].back(), psi[0][0].back()};
        for (std::size_t d = 0; d < 2; ++d)
        {
            for (double& value : psi[d][1]) { value += corner[d]; }
        }
        return psi;
    }

    /// Psi is a function that blends the values on the boundary (Coons 1967), and a rest that vanishes there.
    void solveBox(RealField& source)
    {
        const std::array<FacePair, 2> faces{FacePair(lattice_, lattice_.direction(0)),
                                            FacePair(lattice_, lattice_.direction(1))};
        const auto psi = valuesOfBox(faces);
        std::array<SideValues, 2> curvature; // second derivatives of psi along the faces
        RealField slope(1, U_.size());
        for (int d = 0; d < 2; ++d)
        {
            derivatives_.derivative(U_, d, 1 - d, slope[0]);
            for (double& value : slope[0]) { value *= slopeSign(1 - d); }
            curvature[at(d)] = faces[at(d)].valuesOf(slope[0]);
            for (std::size_t side = 0; side < 2; ++side)
            {
                if (flowsThrough(faces[at(d)].faces[side], U_[d])) { continue; }
                std::ranges::fill(curvature[at(d)][side], 0.0);
            }
        }

        const Axis& a = lattice_.activeAxis(0);
        const Axis& b = lattice_.activeAxis(1);
        RealField blend(1, U_.size());
        std::size_t n = 0;
        for (std::size_t j = 0; j < static_cast<std::size_t>(b.count); ++j)
        {
            const double y = (b.coordinate(static_cast<int>(j)) - b.origin) / b.extent;
            for (std::size_t i = 0; i < static_cast<std::size_t>(a.count); ++i, ++n)
            {
                const double x = (a.coordinate(static_cast<int>(i)) - a.origin) / a.extent;
                blend[0][n] = (1 - x) * psi[0][0][j] + x * psi[0][1][j] + (1 - y) * psi[1][0][i] + y * psi[1][1][i] -
                              x * (1 - y) * psi[1][0].back() - (1 - x) * y * psi[0][0].back() -
                              x * y * psi[0][1].back();
                source[0][n] -= (1 - x) * curvature[0][0][j] + x * curvature[0][1][j] + (1 - y) * curvature[1][0][i] +
                                y * curvature[1][1][i];
            }
        }
        // Where walls meet, the curvatures of psi along both are all its Laplacian, and the blend has them.
        if (!a.staggered && !b.staggered)
        {
            const auto row = static_cast<std::size_t>(a.count);
            for (const std::size_t corner : {std::size_t{0}, row - 1, U_.size() - row, U_.size() - 1})
            {
                source[0][corner] = 0;
            }
        }
        solveCompact(source);
        for (n = 0; n < blend.size(); ++n) { result_.values[0][n] += blend[0][n]; }
    }

    /// Solves with psi = 0 on the boundary by the compact second derivative d2/(1 + dx^2 d2/12) of order 4 (Collatz
    /// 1960), which feels the source at the walls nowhere else but next to them.
    void solveCompact(RealField& source)
    {
        // A sine series takes the source for zero at walls. What that leaves out decays from point to point by the
        // root of r^2 + 10 r + 1.
        const double decay = -5 + std::sqrt(24.0);
        std::array<AxisEnds, 3> ends;
        for (int d = 0; d < 2; ++d)
        {
            ends[direction(d)] = {End::dirichlet, End::dirichlet};
            const Axis& axis = lattice_.activeAxis(d);
            if (axis.staggered) { continue; }
            const std::size_t step = d == 0 ? 1 : static_cast<std::size_t>(lattice_.activeAxis(0).count);
            const std::size_t line = d == 0 ? static_cast<std::size_t>(lattice_.activeAxis(0).count) : 1;
            const auto count = static_cast<std::size_t>(axis.count);
            const auto lines = source.size() / count;
            for (std::size_t l = 0; l < lines; ++l)
            {
                double* const first = source[0].data() + l * line;
                double* const last = first + (count - 1) * step;
                double low = *first;
                double high = *last;
                for (std::size_t i = 0; i < count; ++i)
                {
                    first[i * step] -= low;
                    *(last - i * step) -= high;
                    low *= decay;
                    high *= decay;
                }
            }
        }
        const auto symbol = [](double k, double spacing)
        {
            const double sine2 = std::pow(std::sin(0.5 * k * spacing), 2);
            return 4 * sine2 / (spacing * spacing * (1 - sine2 / 3));
        };
        BoundedPoisson(lattice_, ends, PlanEffort::estimated, symbol).solve(source, {}, result_.values);
    }

    void addMeanFlow()
    {
        std::array<std::vector<double>, 3> gain;
        for (std::size_t d = 0; d < 3; ++d)
        {
            const int count = lattice_.axis(static_cast<int>(d)).count;
            for (int i = 0; i < count; ++i) { gain[d].push_back(result_.periodGain[d] * i / count); }
        }
        std::size_t n = 0;
        for (const double z : gain[2])
        {
            for (const double y : gain[1])
            {
                for (const double x : gain[0]) { result_.values[0][n++] += x + y + z; }
            }
        }
    }

    const RealField& U_;
    const Lattice& lattice_;
    VelocityDerivatives derivatives_;
    StreamFunction result_;
};

} // namespace

StreamFunction streamFunction(const RealField& U, const Lattice& lattice)
{
    assert(lattice.dimensions() == 2 && U.components() == 2 && U.size() == lattice.points());
    return Plane(U, lattice).solve();
}

} // namespace isph
