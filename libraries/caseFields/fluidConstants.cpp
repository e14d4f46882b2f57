#include "caseFields/fluidConstants.hpp"

#include "dictionary/Dictionary.hpp"

namespace isph
{

std::vector<std::pair<std::string, double>> fluidConstants(const Case& theCase)
{
    std::vector<std::pair<std::string, double>> constants;
    if (!theCase.has("constant/transportProperties")) { return constants; }
    const Dictionary properties = theCase.dictionary("constant/transportProperties");
    if (properties.has("nu"))
    {
        constants.emplace_back("nu", properties.dimensionedNumber("nu", {0, 2, -1, 0, 0, 0, 0}));
    }
    if (properties.has("rho"))
    {
        constants.emplace_back("rho", properties.dimensionedNumber("rho", {1, -3, 0, 0, 0, 0, 0}));
    }
    if (properties.has("DT"))
    {
        constants.emplace_back("DT", properties.dimensionedNumber("DT", {0, 2, -1, 0, 0, 0, 0}));
    }
    return constants;
}

} // namespace isph
