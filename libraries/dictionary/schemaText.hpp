#pragma once

#include "dictionary/Schema.hpp"

#include <string>
#include <vector>

namespace isph
{

/// What the value of a key must be: "a number or auto".
std::string shape(const Key& key);

/// How to write a key: "endTime <number>; (time at which the run ends [s])".
std::string usage(const Key& key);

/// What a key means, with an example where it has a default: "ratio of h to dx, e.g. smoothingLength 1.5;".
std::string hint(const Key& key);

/// A dictionary with every key at its default and its meaning as a comment. Keys without default, and those that take
/// any name, are shown as comments, so that the text parses.
std::string annotatedText(const std::string& name, const std::vector<Key>& keys);

} // namespace isph
