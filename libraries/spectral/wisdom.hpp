#pragma once

#include <filesystem>
#include <functional>

namespace isph
{

/// File in the user's cache directory that keeps what measuring plans has taught ($XDG_CACHE_HOME or $HOME/.cache);
/// empty where there is no such directory.
std::filesystem::path wisdomFile();

/// Runs a planner with the saved wisdom loaded, and saves what it adds. Other programs that plan wait meanwhile, so
/// that two runs started together end up with the same plans. \return whether wisdom can be kept; if not, the planner
/// should estimate, or the next run would meet other plans
bool withWisdom(const std::function<void()>& planner);

} // namespace isph
