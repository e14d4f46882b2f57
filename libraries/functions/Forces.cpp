#include "functions/Forces.hpp"

#include <string>
#include <utility>

namespace isph
{

namespace
{

using Vector = std::array<double, 3>;

std::vector<CsvColumn> columnsOf(int dimensions, bool inNewton)
{
    const bool plane = dimensions == 2;
    const std::string force = inNewton ? (plane ? "N/m" : "N") : (plane ? "m3/s2" : "m4/s2");
    const std::string moment = inNewton ? (plane ? "N" : "N m") : (plane ? "m4/s2" : "m5/s2");
    std::vector<CsvColumn> columns{{"time", "s"}, {"step"}};
    const std::array<CsvColumn, 4> vectors{
        {{"pressureForce", force}, {"viscousForce", force}, {"pressureMoment", moment}, {"viscousMoment", moment}}};
    for (const CsvColumn& vector : vectors)
    {
        for (const char* axis : {".x", ".y", ".z"}) { columns.push_back({vector.name + axis, vector.unit}); }
    }
    return columns;
}

/// A force that adds up, and its moment.
struct Sum
{
    Vector force{};
    Vector moment{};

    void add(const Vector& arm, const Vector& part)
    {
        for (std::size_t d = 0; d < 3; ++d)
        {
            const std::size_t a = (d + 1) % 3;
            const std::size_t b = (d + 2) % 3;
            force[d] += part[d];
            moment[d] += arm[a] * part[b] - arm[b] * part[a];
        }
    }
};

} // namespace

Forces::Forces(std::filesystem::path file, const Lattice& lattice, std::vector<LatticeFace> faces, double nu,
               const double* rho, std::array<double, 3> centre)
    : lattice_(lattice),
      gradients_(lattice, std::move(faces)),
      nu_(nu),
      rho_(rho != nullptr ? *rho : 1),
      centre_(centre),
      csv_(std::move(file), columnsOf(lattice.dimensions(), rho != nullptr))
{
}

void Forces::execute(const FlowAtTime& now)
{
    gradients_.differentiate(now.flow.velocity());
    const RealField& p = now.flow.pressure(now.time);
    Sum ofPressure;
    Sum ofViscosity;
    for (std::size_t f = 0; f < gradients_.faces().size(); ++f)
    {
        const LatticeFace& face = gradients_.faces()[f];
        const RealField rate = gradients_.tractionRate(f);
        std::vector<double> pOnFace(face.points());
        face.values(p[0], pOnFace);
        for (std::size_t n = 0; n < face.points(); ++n)
        {
            const double area = rho_ * face.weights()[n];
            Vector arm{};
            Vector viscous{};
            for (int c = 0; c < lattice_.dimensions(); ++c)
            {
                const auto d = static_cast<std::size_t>(lattice_.direction(c));
                arm[d] = face.coordinates()[d][n] - centre_[d];
                viscous[d] = -area * nu_ * rate[c][n];
            }
            Vector pressure{};
            pressure[static_cast<std::size_t>(face.direction())] = area * pOnFace[n] * face.outward();
            ofPressure.add(arm, pressure);
            ofViscosity.add(arm, viscous);
        }
    }
    std::vector<double> row{now.time, static_cast<double>(now.step)};
    for (const Vector& vector : {ofPressure.force, ofViscosity.force, ofPressure.moment, ofViscosity.moment})
    {
        row.insert(row.end(), vector.begin(), vector.end());
    }
    csv_.row(row);
}

} // namespace isph
