#pragma once

#include "dictionary/Dictionary.hpp"
#include "lattice/Lattice.hpp"

#include <array>
#include <vector>

namespace isph
{

/// The patches of a lattice dictionary, each with its faces in the order xMin ... zMax.
/// \param extent of the box; an axis with extent 0 has no faces
/// \throws Error(input) with all slips at once: an unknown face or one of an axis left out, a face in no patch or in
/// two,
///         a periodic patch with one face of an axis.
std::vector<Patch> readPatches(const Dictionary& dictionary, const std::array<double, 3>& extent);

/// How the axes end, as the patches have it.
std::array<Axis::Ends, 3> endsOfAxes(const std::vector<Patch>& patches);

/// "xMin" ... "zMax": face 2*axis + (0 lower, 1 upper).
const std::array<std::string, 6>& faceNames();

} // namespace isph
