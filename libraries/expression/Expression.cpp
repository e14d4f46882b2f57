#include "expression/Expression.hpp"

#include "core/Error.hpp"
#include "expression/Formula.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <muParser.h>
#include <numbers>
#include <vector>

namespace isph
{

namespace
{

// Terms of all sums of a formula at one point: enough for any series, little enough never to hang.
constexpr long mostTerms = 100000;

/// The point a formula is evaluated at.
struct Point
{
    double x = 0;
    double y = 0;
    double z = 0;
    double t = 0;
    long terms = 0; ///< of sums, added up at this point
};

double powerOf(double base, double exponent) { return std::pow(base, exponent); }
double signOf(double value) { return value > 0 ? 1.0 : value < 0 ? -1.0 : 0.0; }
double squareOf(double value) { return value * value; }
double radians(double degrees) { return degrees * std::numbers::pi / 180; }
double degrees(double radians) { return radians * 180 / std::numbers::pi; }
double smallest(const double* values, int count) { return *std::min_element(values, values + count); }
double largest(const double* values, int count) { return *std::max_element(values, values + count); }

/// The finaliser of splitmix64 (Steele, Lea, Flood 2014): every bit of the input moves every bit of the result.
std::uint64_t mixed(std::uint64_t bits)
{
    bits += 0x9e3779b97f4a7c15U;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31);
}

/// Uniform in [-1, 1], a fixed function of seed and point (not of time).
double noiseAt(void* userData, double seed)
{
    const Point& point = *static_cast<const Point*>(userData);
    std::uint64_t bits = 0;
    for (const double value : {seed, point.x, point.y, point.z})
    {
        bits = mixed(bits ^ std::bit_cast<std::uint64_t>(value + 0.0)); // + 0.0: minus zero is the same point
    }
    return std::ldexp(static_cast<double>(bits >> 11), -52) - 1.0;
}

struct Sum;

/// A formula as muParser runs it, with the sums that it calls.
struct Program
{
    mu::Parser parser;
    std::vector<std::unique_ptr<Sum>> sums;

    double operator()() const { return parser.Eval(); }
};

using Variables = std::vector<std::pair<std::string, double*>>;

struct Sum
{
    double n = 0;
    Program from;
    Program to;
    Program term;
    Point* point = nullptr;
    const Origin* origin = nullptr;
};

double sumTerms(void* userData)
{
    Sum& sum = *static_cast<Sum*>(userData);
    const double from = sum.from();
    const double to = sum.to();
    const bool whole = from == std::floor(from) && to == std::floor(to);
    if (!whole || !(std::abs(from) < 1e9) || !(std::abs(to) < 1e9))
    {
        throw Error(Fault::input, *sum.origin,
                    fmt::format("sums from {} to {}, but both ends must be whole numbers", from, to));
    }
    sum.point->terms += std::max(0L, static_cast<long>(to - from) + 1);
    if (sum.point->terms > mostTerms)
    {
        throw Error(Fault::input, *sum.origin, fmt::format("sums more than {} terms at one point", mostTerms));
    }
    double result = 0;
    for (long n = static_cast<long>(from); n <= static_cast<long>(to); ++n)
    {
        sum.n = static_cast<double>(n);
        result += sum.term();
    }
    return result;
}

/// What muParser needs to turn a Formula into a Program.
struct Builder
{
    const std::string& text;
    const Origin& origin;
    Point& point;

    void build(const Formula& formula, const Variables& variables, Program& program) const;

private:
    void defineFunctions(mu::Parser& parser) const;
    void parse(const Formula& formula, mu::Parser& parser) const;
};

void Builder::defineFunctions(mu::Parser& parser) const
{
    using One = double (*)(double);
    using Two = double (*)(double, double);
    parser.ClearFun();
    parser.ClearConst();
    parser.DefineConst("pi", std::numbers::pi);
    for (const auto& [name, function] : std::initializer_list<std::pair<const char*, One>>{
             {"sin", std::sin},   {"cos", std::cos},     {"tan", std::tan},    {"asin", std::asin},
             {"acos", std::acos}, {"atan", std::atan},   {"sinh", std::sinh},  {"cosh", std::cosh},
             {"tanh", std::tanh}, {"exp", std::exp},     {"log", std::log},    {"sqrt", std::sqrt},
             {"abs", std::fabs},  {"mag", std::fabs},    {"erf", std::erf},    {"floor", std::floor},
             {"ceil", std::ceil}, {"log10", std::log10}, {"cbrt", std::cbrt},  {"sign", signOf},
             {"sqr", squareOf},   {"degToRad", radians}, {"radToDeg", degrees}})
    {
        parser.DefineFun(name, function);
    }
    parser.DefineFun("pow", powerOf);
    parser.DefineFun("atan2", static_cast<Two>(std::atan2));
    parser.DefineFun("hypot", static_cast<Two>(std::hypot));
    parser.DefineFun("min", smallest);
    parser.DefineFun("max", largest);
    parser.DefineFunUserData("noise", noiseAt, &point, false);
}

void Builder::build(const Formula& formula, const Variables& variables, Program& program) const
{
    defineFunctions(program.parser);
    program.parser.DefineVar("x", &point.x);
    program.parser.DefineVar("y", &point.y);
    program.parser.DefineVar("z", &point.z);
    program.parser.DefineVar("t", &point.t);
    for (const auto& [name, value] : formula.constants) { program.parser.DefineConst(name, value); }
    for (const auto& [name, value] : variables) { program.parser.DefineVar(name, value); }
    for (const Formula::Sum& part : formula.sums)
    {
        auto sum = std::make_unique<Sum>();
        sum->point = &point;
        sum->origin = &origin;
        Variables inner = variables;
        build(part.from, variables, sum->from);
        build(part.to, variables, sum->to);
        inner.emplace_back(part.variable, &sum->n);
        build(part.term, inner, sum->term);
        program.parser.DefineFunUserData(fmt::format("_s{}", program.sums.size()), sumTerms, sum.get(), false);
        program.sums.push_back(std::move(sum));
    }
    parse(formula, program.parser);
}

void Builder::parse(const Formula& formula, mu::Parser& parser) const
{
    try
    {
        parser.SetExpr(formula.text);
        // muParser reads a formula when its variables are asked for, without running it.
        static_cast<void>(parser.GetUsedVar());
    }
    catch (const mu::ParserError& error)
    {
        const auto position = static_cast<std::size_t>(std::max(0, error.GetPos()));
        const bool atEnd = error.GetPos() < 0 || position >= formula.position.size();
        throw formulaError(origin, text, atEnd ? formula.position.back() : formula.position[position],
                           error.GetCode() == mu::ecUNEXPECTED_EOF ? "ends too early" : "goes wrong");
    }
}

} // namespace

struct Expression::Parser
{
    std::string text;
    Origin origin;
    Point point;
    bool space = false;
    bool time = false;
    Program program;

    double evaluate(double x, double y, double z, double t);
};

double Expression::Parser::evaluate(double x, double y, double z, double t)
{
    point = {x, y, z, t, 0};
    double value = 0;
    try
    {
        value = program();
    }
    catch (const mu::ParserError& error)
    {
        throw Error(Fault::input, origin, fmt::format("\"{}\": {}", text, error.GetMsg()));
    }
    if (!std::isfinite(value))
    {
        const std::string where = space || time ? fmt::format(" at ({} {} {}), t = {}", x, y, z, t) : std::string();
        throw Error(Fault::input, origin,
                    fmt::format("\"{}\" is {}{}", text, std::isnan(value) ? "not a number" : "infinite", where));
    }
    return value;
}

Expression::Expression(const std::string& text, const Constants& constants, const Origin& origin)
    : parser_(std::make_unique<Parser>())
{
    parser_->text = text;
    parser_->origin = origin;
    const Formula formula = readFormula(text, constants, origin);
    parser_->space = formula.usesSpace;
    parser_->time = formula.usesTime;
    Builder{parser_->text, parser_->origin, parser_->point}.build(formula, {}, parser_->program);
}

Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;

double Expression::operator()(double x, double y, double z, double t) const { return parser_->evaluate(x, y, z, t); }

void Expression::evaluate(std::span<const double> x, std::span<const double> y, std::span<const double> z, double t,
                          std::span<double> values) const
{
    assert(x.empty() || x.size() == values.size());
    assert(y.empty() || y.size() == values.size());
    assert(z.empty() || z.size() == values.size());
    if (!dependsOnSpace() && !values.empty())
    {
        std::ranges::fill(values, parser_->evaluate(0, 0, 0, t));
        return;
    }
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        values[i] = parser_->evaluate(x.empty() ? 0 : x[i], y.empty() ? 0 : y[i], z.empty() ? 0 : z[i], t);
    }
}

bool Expression::dependsOnTime() const { return parser_->time; }
bool Expression::dependsOnSpace() const { return parser_->space; }
const std::string& Expression::text() const { return parser_->text; }

} // namespace isph
