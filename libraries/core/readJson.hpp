#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isph
{

/// The numbers of a JSON text by their scoped names: "errors.U.relL2", elements of arrays by number, "points.0".
struct JsonValues
{
    std::map<std::string, double, std::less<>> numbers; ///< true is 1, false 0, null not a number

    std::optional<double> number(std::string_view name) const;
    std::vector<std::string> numberNames() const;
};

/// \param shownAs what messages call the text
/// \throws Error(input) naming the line where it is no JSON.
JsonValues parseJson(std::string_view text, const std::string& shownAs);

/// The values of a file, e.g. postProcessing/report.json.
/// \throws Error(input) if it cannot be read or is no JSON.
JsonValues readJson(const std::filesystem::path& file, const std::string& shownAs);

} // namespace isph
