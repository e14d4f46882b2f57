#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isph::test
{

/// What a scene asks for.
enum class Load
{
    alone,     ///< nothing that can be left out
    everything ///< all that can be switched on for it, functions at every step
};

/// A scene of the table of what is left out.
struct SceneOnTrial
{
    std::string name;
    int dimensions;
    bool viscous;
    int boundedAxes;
    int points; ///< along an axis, in the table
    int few;    ///< in tests
};

const std::vector<SceneOnTrial>& scenesOnTrial();

/// Writes the case of a scene: every file, constant/lattice too.
/// \param steps that it is to take
void writeScene(const std::filesystem::path& folder, const SceneOnTrial& scene, Load load, int points, int steps);

} // namespace isph::test
