#pragma once

#include "boundary/FlowBoundary.hpp"
#include "case/readTimeControl.hpp"
#include "core/Error.hpp"
#include "fields/Field.hpp"
#include "flow/describeScene.hpp"
#include "flow/FlowSettings.hpp"
#include "flow/Fluid.hpp"
#include "lattice/Lattice.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isph
{

/// A whole case, read as the solver reads it, but to the end: a part that is wrong leaves its slips behind, and reading
/// goes on with the parts that do not need it.
struct CaseReading
{
    std::vector<Complaint> slips;      ///< why the case cannot run
    std::vector<std::string> warnings; ///< it runs, but a user should know
    std::vector<std::string> unread;   ///< parts that could not be looked at because of the slips

    std::optional<Case> theCase;
    std::optional<Dictionary> controlDict; ///< completed, as the others
    std::optional<Dictionary> transportProperties;
    std::optional<Dictionary> schemes;
    std::optional<Dictionary> solution;
    std::optional<StartFolder> start;
    std::optional<TimeControl> control;
    std::optional<Lattice> lattice;
    std::optional<Fluid> fluid;
    std::optional<FlowSettings> settings;
    std::optional<Dictionary> U; ///< of the start folder
    std::optional<Dictionary> p;
    std::optional<FlowBoundary> boundary; ///< with the data of the start
    std::optional<RealField> velocity;    ///< at the points, as written but for the walls: not projected

    bool scalar = false;                       ///< a case of scalarTransportFoam; nu of its fluid is DT
    std::optional<SceneDescription> transport; ///< of such a case
    std::optional<double> memory;              ///< that it needs [bytes]
};

CaseReading readWholeCase(const std::filesystem::path& directory);

} // namespace isph
