#include "expression/Expression.hpp"
#include "core/Error.hpp"
#include "support/messageOf.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace isph
{
namespace
{

using testing::Each;
using testing::ElementsAre;

const Origin origin{"0/U", 11, "internalField"};

std::optional<double> constants(const std::string& name)
{
    if (name == "nu") { return 0.01; }
    if (name == "min") { return 5; } // a user may call a constant like a function
    return std::nullopt;
}

double valueOf(const std::string& text, double x = 0, double y = 0, double z = 0, double t = 0)
{
    return Expression(text, constants, origin)(x, y, z, t);
}

std::string messageFor(const std::string& text)
{
    return messageOf([&] { static_cast<void>(valueOf(text, 1, 2, 3, 4)); });
}

struct Case
{
    std::string text;
    double value; // at x = 0.5, y = 0.25, z = 2, t = 3
};

class Value : public testing::TestWithParam<Case>
{
};

TEST_P(Value, IsThatOfTheMathematics) { EXPECT_DOUBLE_EQ(valueOf(GetParam().text, 0.5, 0.25, 2, 3), GetParam().value); }

INSTANTIATE_TEST_SUITE_P(Operators, Value,
                         testing::Values(Case{"1 + 2*3", 7}, Case{"(1 + 2)*3", 9}, Case{"7 - 2 - 1", 4},
                                         Case{"8/4/2", 1}, Case{"2^3", 8}, Case{"2^3^2", 512}, Case{"-2^2", -4},
                                         Case{"2^-1", 0.5}, Case{"2*-3", -6}, Case{"+x", 0.5}, Case{"-(-x)", 0.5},
                                         Case{"1e-3", 0.001}, Case{".5", 0.5}, Case{"2.", 2}, Case{"1.5E+2", 150},
                                         Case{"1 < 2", 1}, Case{"2 <= 1", 0}, Case{"1 > 2", 0}, Case{"2 >= 2", 1},
                                         Case{"1 == 1", 1}, Case{"1 != 1", 0}, Case{"1 && 0", 0}, Case{"1 || 0", 1},
                                         Case{"x < y || z > 1", 1}, Case{"x > 0 ? 10 : 20", 10},
                                         Case{"x < 0 ? 10 : y < 0 ? 20 : 30", 30}, Case{" 1\t+\n1 ", 2}));

INSTANTIATE_TEST_SUITE_P(Names, Value,
                         testing::Values(Case{"x", 0.5}, Case{"y", 0.25}, Case{"z", 2}, Case{"t", 3},
                                         Case{"pi", std::numbers::pi}, Case{"pi()", std::numbers::pi},
                                         Case{"2*pi( )*x", std::numbers::pi}, Case{"nu*t", 0.03}, Case{"min + 1", 6},
                                         Case{"min(1, min)", 1}));

INSTANTIATE_TEST_SUITE_P(
    Functions, Value,
    testing::Values(Case{"sin(x)", std::sin(0.5)}, Case{"cos(x)", std::cos(0.5)}, Case{"tan(x)", std::tan(0.5)},
                    Case{"asin(x)", std::asin(0.5)}, Case{"acos(x)", std::acos(0.5)}, Case{"atan(x)", std::atan(0.5)},
                    Case{"atan2(x, -y)", std::atan2(0.5, -0.25)}, Case{"sinh(x)", std::sinh(0.5)},
                    Case{"cosh(x)", std::cosh(0.5)}, Case{"tanh(x)", std::tanh(0.5)}, Case{"exp(x)", std::exp(0.5)},
                    Case{"log(x)", std::log(0.5)}, Case{"sqrt(x)", std::sqrt(0.5)}, Case{"abs(-x)", 0.5},
                    Case{"min(x, y, z)", 0.25}, Case{"max(x, y, z)", 2}, Case{"max(x)", 0.5},
                    Case{"erf(x)", std::erf(0.5)}, Case{"pow(z, 3)", 8}, Case{"floor(-x)", -1}, Case{"ceil(x)", 1},
                    Case{"sign(-x)", -1}, Case{"sign(0)", 0}, Case{"sign(z)", 1}, Case{"log10(1000)", 3},
                    Case{"sqr(t)", 9}, Case{"cbrt(27)", 3}, Case{"mag(-2)", 2}, Case{"hypot(3, 4)", 5},
                    Case{"degToRad(180)", std::numbers::pi}, Case{"radToDeg(pi)", 180},
                    Case{"sin(cos(x)) + max(1, min(3, 2))", std::sin(std::cos(0.5)) + 2}));

INSTANTIATE_TEST_SUITE_P(Sums, Value,
                         testing::Values(Case{"sum(n, 1, 4, n)", 10}, Case{"sum(n, 3, 3, n)", 3},
                                         Case{"sum(n, 2, 1, n)", 0}, Case{"sum(k, 0, 3, x^k)", 1.875},
                                         Case{"2*sum(n, 1, 2, n) + 1", 7}, Case{"sum(n, 1, 3, sum(m, 1, n, m))", 10},
                                         Case{"sum(n, 1, 2, sum(n, 1, 2, n))", 6}, // the inner n hides the outer
                                         Case{"sum(n, 1, 2, max(n, 1.5)) + sum(m, 1, 2, m)", 6.5},
                                         Case{"sum(n, -1, z, n*t)", 6}));

TEST(Expression, ConvergesToAFourierSeries)
{
    // The square wave, odd terms: an error of order 1/64 away from its jumps.
    EXPECT_NEAR(valueOf("4/pi*sum(n, 1, 64, sin((2*n - 1)*x)/(2*n - 1))", 1.5), 1, 0.01);
}

TEST(Expression, NoiseIsAFixedFunctionOfThePoint)
{
    EXPECT_EQ(valueOf("noise(1)", 0.1, 0.2, 0.3, 0), valueOf("noise(1)", 0.1, 0.2, 0.3, 7));
    EXPECT_EQ(valueOf("noise(1)", 0.0), valueOf("noise(1)", -0.0));
    EXPECT_NE(valueOf("noise(1)", 0.1), valueOf("noise(2)", 0.1));
    EXPECT_NE(valueOf("noise(1)", 0.1, 0.2), valueOf("noise(1)", 0.2, 0.1));
}

TEST(Expression, NoiseIsUniformBetweenMinusOneAndOne)
{
    constexpr int points = 10000;
    const Expression noise("noise(42)", constants, origin);
    double mean = 0;
    double square = 0;
    for (int i = 0; i < points; ++i)
    {
        const double value = noise(i / 7.0, i / 3.0, 0, 0);
        ASSERT_LE(std::abs(value), 1);
        mean += value / points;
        square += value * value / points;
    }
    // Mean 0 and variance 1/3, within four standard deviations of the estimates.
    EXPECT_NEAR(mean, 0, 4 * std::sqrt(1.0 / 3 / points));
    EXPECT_NEAR(square, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / points));
}

TEST(Expression, KnowsWhatItDependsOn)
{
    const auto of = [](const char* text) { return Expression(text, constants, origin); };
    EXPECT_FALSE(of("nu*pi").dependsOnSpace());
    EXPECT_FALSE(of("nu*pi").dependsOnTime());
    EXPECT_TRUE(of("z").dependsOnSpace());
    EXPECT_TRUE(of("noise(1)").dependsOnSpace());
    EXPECT_FALSE(of("noise(1)").dependsOnTime());
    EXPECT_TRUE(of("sum(n, 1, 2, n*t)").dependsOnTime());
    EXPECT_TRUE(of("sum(n, 1, x, 1)").dependsOnSpace());
    EXPECT_EQ(of("x + 1").text(), "x + 1");
}

TEST(Expression, EvaluatesManyPoints)
{
    const std::vector<double> x = {0, 1, 2};
    const std::vector<double> y = {5, 6, 7};
    std::vector<double> values(3);
    Expression("x*y + t", constants, origin).evaluate(x, y, {}, 10, values);
    EXPECT_THAT(values, ElementsAre(10, 16, 24));
    Expression("nu + t", constants, origin).evaluate({}, {}, {}, 1, values);
    EXPECT_THAT(values, Each(1.01));
}

TEST(Expression, MovesWithItsSums)
{
    Expression first("sum(n, 1, 3, n*x)", constants, origin);
    Expression second = std::move(first);
    EXPECT_EQ(second(2, 0, 0, 0), 12);
}

TEST(Expression, NamesThePointWhereItIsNotFinite)
{
    std::vector<double> values(2);
    const std::vector<double> x = {1, 0};
    const std::vector<double> zero = {0, 0};
    const Expression inverse("1/x", constants, origin);
    EXPECT_EQ(messageOf([&] { inverse.evaluate(x, zero, zero, 0.5, values); }),
              "0/U:11: internalField: \"1/x\" is infinite at (0 0 0), t = 0.5");
    EXPECT_EQ(messageFor("sqrt(-x)"), "0/U:11: internalField: \"sqrt(-x)\" is not a number at (1 2 3), t = 4");
    EXPECT_EQ(messageFor("log(0)"), "0/U:11: internalField: \"log(0)\" is infinite");
}

struct Slip
{
    std::string text;
    std::string message; // behind the origin
};

class Message : public testing::TestWithParam<Slip>
{
};

TEST_P(Message, SaysWhereAndWhat)
{
    EXPECT_EQ(messageFor(GetParam().text), "0/U:11: internalField: " + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Names, Message,
    testing::Values(
        Slip{"sni(x)", "\"sni(x)\" has the unknown function 'sni' (character 1)\n    did you mean 'sin'?"},
        Slip{"1 + qwerty", "\"1 + qwerty\" has the unknown name 'qwerty' (character 5)\n"
                           "    define it in the same dictionary, e.g. qwerty 1;"},
        Slip{"nuu", "\"nuu\" has the unknown name 'nuu' (character 1)\n    did you mean 'nu'?"},
        Slip{"Nu", "\"Nu\" has the unknown name 'Nu' (character 1)\n    did you mean 'nu'?"},
        Slip{"un", "\"un\" has the unknown name 'un' (character 1)\n    did you mean 'nu'?"},
        Slip{"sin", "\"sin\" has the function 'sin' without its parentheses (character 1)"},
        Slip{"$nu", "\"$nu\" has a '$' (character 1)\n    write the name without it"},
        Slip{"sum(x, 1, 2, x)", "\"sum(x, 1, 2, x)\" has a sum over 'x', which is taken (character 5)\n    sum over n"},
        Slip{"sum(n + 1, 1, 2, 3)", "\"sum(n + 1, 1, 2, 3)\" has a sum whose first part is not a name (character 5)\n"
                                    "    write sum(n, 1, 64, ...)"}));

INSTANTIATE_TEST_SUITE_P(
    Syntax, Message,
    testing::Values(Slip{"", "\"\" is empty where a formula should be (character 1)"},
                    Slip{"sum(n, , 2, n)", "\"sum(n, , 2, n)\" is empty where a formula should be (character 7)"},
                    Slip{"(1 + 2", "\"(1 + 2\" has a '(' that is never closed (character 1)"},
                    Slip{"sum(n, 1, 2, n", "\"sum(n, 1, 2, n\" has a '(' that is never closed (character 4)"},
                    Slip{"1 + 2)", "\"1 + 2)\" has a ')' without its '(' (character 6)"},
                    Slip{"1 +", "\"1 +\" ends too early (character 3)"},
                    Slip{"1 + * 2", "\"1 + * 2\" goes wrong (character 5)"},
                    Slip{"1 2", "\"1 2\" goes wrong (character 3)"},
                    Slip{"x = 1", "\"x = 1\" has a '=' (character 3)\n    write == to compare"},
                    Slip{"x & y", "\"x & y\" has a single '&' (character 3)\n    write && or ||"},
                    Slip{"x # y", "\"x # y\" has the character '#', which means nothing here (character 3)"},
                    Slip{"x \xC2\xB7 y", "\"x \xC2\xB7 y\" has a character that means nothing here (character 3)"},
                    Slip{"2x", "\"2x\" has something that is no number (character 1)"},
                    Slip{"1.2.3", "\"1.2.3\" has something that is no number (character 1)"},
                    Slip{"1e999", "\"1e999\" has a number too large or too small to hold (character 1)"},
                    Slip{"(1, 2)", "\"(1, 2)\" has a ',' outside of a function (character 3)"},
                    Slip{"atan2(1)", "\"atan2(1)\" gives 1 to 'atan2', which takes 2 (character 1)"},
                    Slip{"sin()", "\"sin()\" gives 0 to 'sin', which takes 1 (character 1)"},
                    Slip{"max()", "\"max()\" gives 0 to 'max', which takes one or more (character 1)"},
                    Slip{"sum(n, 1, 2)",
                         "\"sum(n, 1, 2)\" has a sum that is not of the form sum(n, 1, 64, ...) (character 1)"}));

INSTANTIATE_TEST_SUITE_P(
    Limits, Message,
    testing::Values(Slip{"sum(n, 1, 1e8, n)", "sums more than 100000 terms at one point"},
                    Slip{"sum(n, 1, 1e5, sum(m, 1, 1e5, 1))", "sums more than 100000 terms at one point"},
                    Slip{"sum(n, 0.5, 2, n)", "sums from 0.5 to 2, but both ends must be whole numbers"},
                    Slip{"sum(n, 1, 1/0, n)", "sums from 1 to inf, but both ends must be whole numbers"}));

TEST(Expression, RefusesWhatNoFormulaIs)
{
    EXPECT_EQ(messageFor(std::string(9000, '1')), "0/U:11: internalField: is a formula of 9000 characters, but at most "
                                                  "8000 are read\n    give parts of it a name in the dictionary");
    EXPECT_THAT(messageFor(std::string(200, '(') + "1" + std::string(200, ')')),
                testing::HasSubstr("has its parentheses nested too deeply (character 101)"));
    std::string nested = "1";
    for (int i = 0; i < 9; ++i) { nested = "sum(n, 1, 1, " + nested + ")"; }
    EXPECT_THAT(messageFor(nested), testing::HasSubstr("has its sums nested too deeply"));
}

TEST(Expression, ShowsThePlaceInALongFormula)
{
    const std::string text = std::string(100, ' ') + "1 + * 2" + std::string(100, ' ');
    EXPECT_THAT(messageFor(text), testing::HasSubstr("\"..." + std::string(26, ' ') + "1 + * 2"));
    EXPECT_THAT(messageFor(text), testing::EndsWith("...\" goes wrong (character 105)"));
}

} // namespace
} // namespace isph
