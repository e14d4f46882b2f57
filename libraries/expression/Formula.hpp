#pragma once

#include "core/Error.hpp"
#include "expression/Expression.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isph
{

/// A function that formulas may call.
struct FormulaFunction
{
    std::string_view name;
    int values; ///< how many it takes; -1: one or more
};

/// The functions of formulas: those of the contract and the ones OpenFOAM's #eval has besides.
const std::vector<FormulaFunction>& formulaFunctions();

/// A formula checked and taken apart for muParser, which sees only generated names: what a user calls a constant can
/// then never clash with a function, and sums become functions of their own.
struct Formula
{
    /// sum(n, from, to, term): the three parts see n under the name `variable`.
    struct Sum;

    std::string text;                  ///< as muParser reads it
    std::vector<std::size_t> position; ///< of each character of text in what the user wrote
    std::vector<std::pair<std::string, double>> constants;
    std::vector<Sum> sums; ///< called as _s0(), _s1(), ...
    bool usesSpace = false;
    bool usesTime = false;
};

struct Formula::Sum
{
    std::string variable; ///< generated name
    Formula from;
    Formula to;
    Formula term;
};

/// Checks a formula and takes it apart.
/// \throws Error(input) at origin: unknown names (with the nearest), unbalanced parentheses, a wrong number of values,
///         characters that mean nothing, formulas longer or nested deeper than any sane one.
Formula readFormula(const std::string& text, const Expression::Constants& constants, const Origin& origin);

/// The error for a slip at a character of a formula (counted from 0).
Error formulaError(const Origin& origin, const std::string& text, std::size_t position, const std::string& what,
                   const std::string& advice = "");

} // namespace isph
