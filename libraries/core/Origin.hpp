#pragma once

#include <string>

namespace isph
{

/// Where a value was written: for messages that lead a user to the line to change.
struct Origin
{
    std::string file;  ///< path relative to the case, e.g. "system/schemes"; empty if there is none
    int line = 0;      ///< counted from 1; 0 if unknown
    std::string entry; ///< scoped key, e.g. "kernel.smoothingLength"; empty for a whole file

    bool operator==(const Origin&) const = default;
};

/// A word that a dictionary chose, with the place it was written at.
struct Word
{
    std::string text;
    Origin origin;

    bool operator==(const Word&) const = default;
};

/// "system/schemes:7: kernel.smoothingLength", with the parts that are known.
std::string toString(const Origin& origin);

} // namespace isph
