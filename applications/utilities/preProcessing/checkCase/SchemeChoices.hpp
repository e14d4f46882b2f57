#pragma once

#include "CaseReading.hpp"

#include <string>
#include <vector>

namespace isph
{

/// An entry of a dictionary as it acts in this case.
struct Choice
{
    std::string key;   ///< scoped: "kernel.order"
    std::string value; ///< resolved: what `auto` came to
    std::string unit;  ///< "dx", "h", or none
    std::string from;  ///< "system/schemes:12", "preset paper2021", or "default"
    bool isDefault = false;
};

/// An entry that was written, is known, and changes nothing here.
struct Idle
{
    Origin origin;
    std::string why;
};

/// Every choice of system/schemes and system/solution, and what is written without effect in the whole case.
struct SchemeChoices
{
    std::vector<Choice> schemes;
    std::vector<Choice> solution;
    std::vector<Idle> idle;
};

/// What the reading got far enough for: choices need settings, the rest its own dictionary.
SchemeChoices schemeChoices(const CaseReading& reading);

} // namespace isph
