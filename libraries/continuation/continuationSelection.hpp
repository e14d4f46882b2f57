#pragma once

#include "continuation/continuedField.hpp"
#include "core/Selection.hpp"
#include "dictionary/Dictionary.hpp"
#include "dictionary/Schema.hpp"

#include <string_view>

namespace isph
{

/// The continuations a dictionary may choose, each made for a bounded axis from its completed sub-dictionary
/// `continuation`.
const Selection<std::unique_ptr<Continuation> (*)(const Dictionary&, const Axis&)>& continuations();

/// What `auto` stands for.
int automaticDegree(std::string_view type);
int automaticSmoothness(std::string_view type);

/// The keys of the sub-dictionary `continuation`.
Key continuationKey();

/// The continuation of a bounded axis.
/// \throws Error(input) at the entry that is out of range, or that asks for more points than the axis has.
std::unique_ptr<Continuation> selectContinuation(const Dictionary& continuation, const Axis& axis);

/// Those of every bounded axis of a lattice.
Continuations selectContinuations(const Dictionary& continuation, const Lattice& lattice);

} // namespace isph
