#pragma once

#include "core/Selection.hpp"
#include "dictionary/Dictionary.hpp"
#include "dictionary/Schema.hpp"
#include "kernels/KernelSettings.hpp"

namespace isph
{

/// The kernels a dictionary may choose, each made from its completed sub-dictionary `kernel`.
const Selection<std::unique_ptr<Kernel> (*)(const Dictionary&)>& kernels();

/// The keys of the sub-dictionary `kernel`; the order's default depends on the scene (10 in periodic boxes).
Key kernelKey(const std::string& defaultOrder);

/// Reads the completed sub-dictionary `kernel`.
/// \throws Error(input) at the entry that is out of range.
KernelSettings selectKernel(const Dictionary& kernel);

} // namespace isph
