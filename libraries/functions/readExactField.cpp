#include "functions/readExactField.hpp"

#include "dictionary/SpaceTimeFunction.hpp"

#include <algorithm>
#include <utility>

namespace isph
{

namespace
{

/// A formula or table at the points of a lattice, found row by row: coordinates of all points would take as much memory
/// as a velocity.
class FunctionOnLattice : public ExactField
{
public:
    FunctionOnLattice(SpaceTimeFunction function, const Lattice& lattice)
        : function_(std::move(function)), lattice_(lattice)
    {
        for (int i = 0; i < lattice.axis(0).count; ++i) { x_.push_back(lattice.axis(0).coordinate(i)); }
    }

    void evaluate(int component, double t, std::span<double> values) const override
    {
        std::vector<double> y(x_.size());
        std::vector<double> z(x_.size());
        std::size_t n = 0;
        for (int iz = 0; iz < lattice_.axis(2).count; ++iz)
        {
            std::ranges::fill(z, lattice_.axis(2).coordinate(iz));
            for (int iy = 0; iy < lattice_.axis(1).count; ++iy)
            {
                std::ranges::fill(y, lattice_.axis(1).coordinate(iy));
                function_.evaluate(component, x_, y, z, t, values.subspan(n, x_.size()));
                n += x_.size();
            }
        }
    }

private:
    SpaceTimeFunction function_;
    Lattice lattice_;
    std::vector<double> x_;
};

} // namespace

std::unique_ptr<const ExactField> readExactField(const Dictionary& exact, std::string_view key, int components,
                                                 const std::vector<std::pair<std::string, double>>& constants,
                                                 const std::filesystem::path& folder, const Lattice& lattice)
{
    return std::make_unique<FunctionOnLattice>(readFunction(exact, key, components, constants, folder), lattice);
}

} // namespace isph
