#include "caseFields/storedFieldText.hpp"

#include <gtest/gtest.h>

namespace isph
{
namespace
{

TEST(StoredFieldText, KeepsWhatReadersKnow)
{
    const Dictionary field = Dictionary::parse(R"--(
L 2; speed 3; steepness 80;
initial { U expression ("steepness*y" "0" "0"); }
dimensions [0 1 -1 0 0 0 0];
internalField $initial.U;
boundaryField
{
    lidSpeed 4;
    lid { type fixedValue; value uniform ($lidSpeed 0 0); }
    inlet { type fixedValue; value expression ("speed*y*(L - y)" "0" "0"); }
    "x(Min|Max)" { type periodic; }
})--",
                                               "0/U");
    EXPECT_EQ(storedFieldText(field, "U", 3), R"--(FoamFile
{
    version         2.0;
    format          ascii;
    class           latticeVectorField;
    object          U;
}

L               2;
speed           3;
dimensions      [0 1 -1 0 0 0 0];
internalField   hdf5 "fields.h5";
boundaryField
{
    lid
    {
        type            fixedValue;
        value           uniform (4 0 0);
    }
    inlet
    {
        type            fixedValue;
        value           expression ("speed*y*(L - y)" "0" "0");
    }
    "x(Min|Max)"
    {
        type            periodic;
    }
}
)--");
}

TEST(StoredFieldText, IsTheSameOfItself)
{
    const std::string text = storedFieldText(
        Dictionary::parse(
            "internalField uniform 0; dimensions [0 2 -2 0 0 0 0]; boundaryField { a { type periodic; } }", "0/p"),
        "p", 1);
    EXPECT_EQ(storedFieldText(Dictionary::parse(text, "1/p"), "p", 1), text);
}

} // namespace
} // namespace isph
