#include "functions/WallProfile.hpp"

#include "core/writeTextFile.hpp"
#include "sampling/SampleSet.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace isph
{

namespace
{

/// Columns that grow face by face, found by their heads.
class GrowingTable
{
public:
    template<class Values>
    void append(const std::string& head, const Values& values, double factor = 1)
    {
        const auto found = std::ranges::find(table_.heads, head);
        const auto index = static_cast<std::size_t>(found - table_.heads.begin());
        if (found == table_.heads.end())
        {
            table_.heads.push_back(head);
            table_.columns.emplace_back();
        }
        for (const double value : values) { table_.columns[index].push_back(factor * value); }
    }

    const SampleTable& table() const { return table_; }

private:
    SampleTable table_;
};

} // namespace

WallProfile::WallProfile(std::filesystem::path folder, const Lattice& lattice, double nu,
                         std::vector<NamedFaces> patches, PressureForm pressure)
    : folder_(std::move(folder)), lattice_(lattice), nu_(nu), pressure_(std::move(pressure))
{
    for (NamedFaces& patch : patches)
    {
        profiles_.push_back({std::move(patch.patch), FaceGradients(lattice, std::move(patch.faces))});
    }
}

void WallProfile::execute(const FlowAtTime& now)
{
    const RealField& U = now.flow.velocity();
    const RealField& p = now.flow.pressure(now.time);
    for (Profile& profile : profiles_)
    {
        profile.gradients.differentiate(U);
        GrowingTable table;
        for (std::size_t f = 0; f < profile.gradients.faces().size(); ++f)
        {
            const LatticeFace& face = profile.gradients.faces()[f];
            for (std::size_t d = 0; d < 3; ++d)
            {
                table.append(fmt::format("{} [m]", "xyz"[d]), face.coordinates()[d]);
            }
            const RealField vorticity = profile.gradients.vorticity(f);
            for (int c = 0; c < vorticity.components(); ++c)
            {
                table.append(vorticity.components() == 1 ? "vorticity [1/s]"
                                                         : fmt::format("vorticity.{} [1/s]", "xyz"[c]),
                             vorticity[c]);
            }
            const RealField rate = profile.gradients.tractionRate(f);
            int component = 0;
            for (int d = 0; d < 3; ++d)
            {
                const std::string head = fmt::format("shearStress.{} [{}]", "xyz"[d], pressure_.unit);
                const bool active = lattice_.axis(d).active();
                // The fluid is pulled by the wall, and the wall the other way.
                if (active && d != face.direction()) { table.append(head, rate[component], -nu_ * pressure_.scale); }
                else { table.append(head, std::vector<double>(face.points(), 0.0)); }
                component += active ? 1 : 0;
            }
            std::vector<double> pOnFace(face.points());
            face.values(p[0], pOnFace);
            table.append(fmt::format("p [{}]", pressure_.unit), pOnFace, pressure_.scale);
        }
        writeTextFile(folder_ / now.name / (profile.patch + ".csv"), csvText(table.table()));
    }
}

} // namespace isph
