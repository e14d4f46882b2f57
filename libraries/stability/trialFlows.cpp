#include "stability/trialFlows.hpp"

#include "continuation/LineLayout.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isph
{

namespace
{

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class PrescribedFlow : public FaceFunction
{
public:
    explicit PrescribedFlow(FlowOfPlace flow) : flow_(std::move(flow)) {}

    void evaluate(int component, std::span<const double> x, std::span<const double> y, std::span<const double> z,
                  double /*t*/, std::span<double> values) const override
    {
        for (std::size_t i = 0; i < values.size(); ++i) { values[i] = flow_(component, x[i], y[i], z[i]); }
    }
    bool dependsOnTime() const override { return false; }

private:
    FlowOfPlace flow_;
};

} // namespace

FlowOfPlace atRest()
{
    return [](int, double, double, double) { return 0.0; };
}

FlowOfPlace uniformFlow(int direction, double velocity)
{
    return [=](int component, double, double, double) { return component == direction ? velocity : 0.0; };
}

RealField fieldOf(const Lattice& lattice, const FlowOfPlace& flow)
{
    const auto [x, y, z] = lattice.coordinates();
    RealField field(lattice.dimensions(), lattice.points());
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        for (std::size_t i = 0; i < field.size(); ++i) { field[d][i] = flow(lattice.direction(d), x[i], y[i], z[i]); }
    }
    return field;
}

FlowBoundary boundaryFor(const Lattice& lattice, const FlowBoundary& boundary, const FlowOfPlace& flow)
{
    std::array<std::array<FaceCondition, 2>, 3> faces;
    for (int direction = 0; direction < 3; ++direction)
    {
        for (const Side side : {Side::low, Side::high})
        {
            const FaceCondition& given = boundary.face(direction, side);
            FaceCondition& face = faces[at(direction)][side == Side::low ? 0 : 1];
            face.patch = given.patch;
            face.velocity = given.velocity;
            face.pressure = given.pressure;
            if (given.velocity == VelocityCondition::value) { face.U = std::make_unique<PrescribedFlow>(flow); }
        }
    }
    return {lattice, std::move(faces)};
}

std::optional<Passage> passageOf(const Lattice& lattice, const FlowBoundary& boundary)
{
    std::optional<Passage> best;
    const auto offer = [&best](const Passage& passage)
    {
        if (!best || passage.kind < best->kind) { best = passage; }
    };
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const int direction = lattice.direction(d);
        if (lattice.axis(direction).periodic())
        {
            offer({d, 1, Passage::Kind::around});
            continue;
        }
        const VelocityCondition low = boundary.face(direction, Side::low).velocity;
        const VelocityCondition high = boundary.face(direction, Side::high).velocity;
        const bool from = low == VelocityCondition::value;
        const bool to = high == VelocityCondition::value;
        if (from && to) { offer({d, 1, Passage::Kind::held}); }
        if (from && high == VelocityCondition::outflow) { offer({d, 1, Passage::Kind::through}); }
        if (to && low == VelocityCondition::outflow) { offer({d, -1, Passage::Kind::through}); }
    }
    return best;
}

double largestStretching(const Lattice& lattice, const RealField& velocity)
{
    std::vector<double> squares(velocity.size(), 0.0);
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const Axis& axis = lattice.activeAxis(d);
        const LineLayout lines = linesAlong(lattice, lattice.direction(d));
        for (int c = 0; c < velocity.components(); ++c)
        {
            const auto u = velocity[c];
            for (std::size_t l = 0; l < lines.lines(); ++l)
            {
                const std::size_t start = lines.start(l);
                for (std::size_t i = 0; i < lines.count; ++i)
                {
                    const bool last = i + 1 == lines.count;
                    if (last && !axis.periodic()) { continue; }
                    const std::size_t here = start + i * lines.inner;
                    const std::size_t next = last ? start : here + lines.inner;
                    const double slope = (u[next] - u[here]) / axis.spacing();
                    squares[here] += slope * slope;
                }
            }
        }
    }
    return std::sqrt(*std::ranges::max_element(squares));
}

} // namespace isph
