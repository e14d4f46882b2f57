#pragma once

#include "transport/readTransport.hpp"
#include "transport/ScalarTransport.hpp"

#include "flow/describeScene.hpp"

namespace isph
{

/// The folder that U is read from, whatever time a run starts from.
inline constexpr const char* carrierFolder = "0";

/// Everything a case says about a scalar and what carries it, but the values of the scalar. Stays where it is: the
/// transport refers to its parts.
struct TransportScene
{
    /// Reads constant/, system/schemes and the dictionaries of T and U.
    /// \throws Error(input) for whatever is wrong there.
    TransportScene(const Case& theCase, const std::string& startTime);

    Lattice lattice;
    double diffusivity; ///< DT [m2/s]
    FlowSettings settings;
    std::unique_ptr<const GivenVelocity> velocity;
    ScalarFile file;
    ScalarBoundary boundary;
};

/// What a scene computes and leaves out, in words.
SceneDescription describeTransport(const TransportScene& scene, const ScalarTransport& transport);

/// Memory of the solver [bytes], without its functions.
double transportMemory(const TransportScene& scene);

/// Brings a scalar into the state of a time folder.
/// \param restart whether the solver wrote the folder: then stored values are taken bit by bit
/// \return the part of its norm that dealiasing dropped
/// \throws Error(input) where what enters the box is not prescribed.
double startTransport(const Case& theCase, const std::string& time, bool restart, double t, TransportScene& scene,
                      ScalarTransport& transport);

} // namespace isph
