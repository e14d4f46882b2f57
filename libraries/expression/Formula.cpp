#include "expression/Formula.hpp"

#include "core/nearestWord.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace isph
{

namespace
{

// What no honest formula reaches: limits that keep hostile text from costing time or stack.
constexpr std::size_t longestFormula = 8000;
constexpr int deepestParentheses = 100;
constexpr int deepestSum = 8;

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// "did you mean 'sin'?" where a known name is near, else the alternative.
std::string suggestion(const std::string& written, const std::vector<std::string>& known, std::string alternative)
{
    const std::optional<std::string> nearest = nearestWord(written, known);
    // Of short names nearly all are near to each other.
    const bool near = nearest && 2 * editDistance(written, *nearest) <= static_cast<int>(written.size());
    return near ? fmt::format("did you mean '{}'?", *nearest) : std::move(alternative);
}

/// A name that a sum binds, and the name muParser knows it by.
struct Bound
{
    std::string name;
    std::string generated;
};

/// One left-to-right pass over a formula.
class Reader
{
public:
    Reader(const std::string& text, const Expression::Constants& constants, const Origin& origin)
        : text_(text), constants_(constants), origin_(origin)
    {
    }

    Formula read(std::size_t begin, std::size_t end);

private:
    /// An open parenthesis: of a function call, or a plain one (function is null).
    struct Open
    {
        std::size_t position;
        const FormulaFunction* function;
        int values;
    };

    [[noreturn]] void fail(std::size_t position, const std::string& what, const std::string& advice = "") const
    {
        throw formulaError(origin_, text_, position, what, advice);
    }

    char at(std::size_t position) const { return position < end_ ? text_[position] : '\0'; }
    std::size_t skipBlanks(std::size_t position) const;
    void emit(std::string_view piece, std::size_t position);
    void readNumber();
    void readName();
    void readCall(const std::string& name, std::size_t begin);
    void readSum(std::size_t begin);
    void readOperator();
    void open(const FormulaFunction* function, std::size_t position);
    void close();
    std::vector<std::pair<std::size_t, std::size_t>> splitArguments(std::size_t open) const;
    [[noreturn]] void failUnknown(const std::string& name, std::size_t position) const;
    std::optional<std::string> constantNear(const std::string& name) const;

    const std::string& text_;
    const Expression::Constants& constants_;
    const Origin& origin_;
    std::vector<Bound> bound_;
    int generated_ = 0;

    // Of the part being read.
    std::size_t here_ = 0;
    std::size_t end_ = 0;
    std::vector<Open> open_;
    Formula result_;
};

std::size_t Reader::skipBlanks(std::size_t position) const
{
    while (position < end_ && std::string_view(" \t\r\n").find(text_[position]) != std::string_view::npos)
    {
        ++position;
    }
    return position;
}

void Reader::emit(std::string_view piece, std::size_t position)
{
    result_.text += piece;
    result_.position.insert(result_.position.end(), piece.size(), position);
}

Formula Reader::read(std::size_t begin, std::size_t end)
{
    // Sums read their parts with the same object: what belongs to the outer part waits here.
    const std::size_t outerHere = here_;
    const std::size_t outerEnd = end_;
    std::vector<Open> outerOpen = std::move(open_);
    Formula outer = std::move(result_);
    here_ = begin;
    end_ = end;
    open_.clear();
    result_ = Formula();

    for (here_ = skipBlanks(here_); here_ < end_; here_ = skipBlanks(here_))
    {
        const char c = at(here_);
        if (isDigit(c) || c == '.') { readNumber(); }
        else if (isLetter(c)) { readName(); }
        else { readOperator(); }
    }
    if (!open_.empty()) { fail(open_.back().position, "has a '(' that is never closed"); }
    if (result_.text.empty()) { fail(begin, "is empty where a formula should be"); }

    Formula result = std::exchange(result_, std::move(outer));
    open_ = std::move(outerOpen);
    here_ = outerHere;
    end_ = outerEnd;
    return result;
}

void Reader::readNumber()
{
    const std::size_t begin = here_;
    double value = 0;
    const auto [last, problem] = std::from_chars(text_.data() + begin, text_.data() + end_, value);
    const std::size_t length = static_cast<std::size_t>(last - (text_.data() + begin));
    if (problem == std::errc::result_out_of_range) { fail(begin, "has a number too large or too small to hold"); }
    if (problem != std::errc() || isLetter(at(begin + length)) || at(begin + length) == '.')
    {
        fail(begin, "has something that is no number");
    }
    here_ += length;
    emit(std::string_view(text_).substr(begin, length), begin);
    emit(" ", begin);
}

void Reader::readName()
{
    const std::size_t begin = here_;
    while (isLetter(at(here_)) || isDigit(at(here_))) { ++here_; }
    const std::string name = text_.substr(begin, here_ - begin);
    const std::size_t next = skipBlanks(here_);
    if (at(next) == '(')
    {
        here_ = next;
        readCall(name, begin);
        return;
    }
    const auto bound = std::ranges::find(bound_.rbegin(), bound_.rend(), name, &Bound::name);
    if (bound != bound_.rend()) { emit(bound->generated, begin); }
    else if (name == "x" || name == "y" || name == "z")
    {
        result_.usesSpace = true;
        emit(name, begin);
    }
    else if (name == "t")
    {
        result_.usesTime = true;
        emit(name, begin);
    }
    else if (name == "pi") { emit(name, begin); }
    else if (const std::optional<double> value = constants_ ? constants_(name) : std::nullopt)
    {
        const std::string generated = fmt::format("_c{}", generated_++);
        result_.constants.emplace_back(generated, *value);
        emit(generated, begin);
    }
    else { failUnknown(name, begin); }
    emit(" ", begin);
}

std::optional<std::string> Reader::constantNear(const std::string& name) const
{
    // Constants can be asked for but not listed, so the likely slips are tried: case, a letter too many, two swapped.
    constexpr std::size_t longest = 40; // a longer name is no slip
    if (!constants_ || name.size() > longest) { return std::nullopt; }
    for (std::size_t i = 0; i < name.size(); ++i)
    {
        std::string otherCase = name;
        otherCase[i] = isDigit(name[i]) || name[i] == '_' ? name[i] : static_cast<char>(name[i] ^ 0x20);
        std::string shorter = name;
        shorter.erase(i, 1);
        std::string swapped = name;
        std::swap(swapped[i], swapped[i == 0 ? 0 : i - 1]);
        for (const std::string& candidate : {otherCase, shorter, swapped})
        {
            if (!candidate.empty() && constants_(candidate)) { return candidate; }
        }
    }
    return std::nullopt;
}

void Reader::failUnknown(const std::string& name, std::size_t position) const
{
    std::vector<std::string> known = {"x", "y", "z", "t", "pi"};
    for (const Bound& bound : bound_) { known.push_back(bound.name); }
    for (const FormulaFunction& function : formulaFunctions()) { known.emplace_back(function.name); }
    const bool isFunction = std::ranges::find(known, name) != known.end();
    if (isFunction) { fail(position, fmt::format("has the function '{}' without its parentheses", name)); }
    if (const auto constant = constantNear(name))
    {
        fail(position, fmt::format("has the unknown name '{}'", name), fmt::format("did you mean '{}'?", *constant));
    }
    fail(position, fmt::format("has the unknown name '{}'", name),
         suggestion(name, known, fmt::format("define it in the same dictionary, e.g. {} 1;", name)));
}

void Reader::readCall(const std::string& name, std::size_t begin)
{
    if (name == "pi" && at(skipBlanks(here_ + 1)) == ')') // OpenFOAM's #eval writes pi()
    {
        here_ = skipBlanks(here_ + 1) + 1;
        emit("pi ", begin);
        return;
    }
    if (name == "sum")
    {
        readSum(begin);
        return;
    }
    const auto function = std::ranges::find(formulaFunctions(), name, &FormulaFunction::name);
    if (function == formulaFunctions().end())
    {
        std::vector<std::string> known;
        for (const FormulaFunction& candidate : formulaFunctions()) { known.emplace_back(candidate.name); }
        fail(begin, fmt::format("has the unknown function '{}'", name),
             suggestion(name, known, fmt::format("known are: {}", listOfWords(name, known))));
    }
    if (name == "noise") { result_.usesSpace = true; }
    emit(name, begin);
    open(&*function, begin);
}

void Reader::open(const FormulaFunction* function, std::size_t position)
{
    if (open_.size() >= deepestParentheses) { fail(position, "has its parentheses nested too deeply"); }
    emit("(", here_);
    open_.push_back({position, function, 1});
    ++here_;
    if (function != nullptr && at(skipBlanks(here_)) == ')') { open_.back().values = 0; }
}

void Reader::close()
{
    if (open_.empty()) { fail(here_, "has a ')' without its '('"); }
    const Open closed = open_.back();
    open_.pop_back();
    if (closed.function != nullptr)
    {
        const int wanted = closed.function->values;
        const bool right = wanted < 0 ? closed.values > 0 : closed.values == wanted;
        if (!right)
        {
            fail(closed.position, fmt::format("gives {} to '{}', which takes {}", closed.values, closed.function->name,
                                              wanted < 0 ? "one or more" : fmt::format("{}", wanted)));
        }
    }
    emit(")", here_);
    ++here_;
}

void Reader::readOperator()
{
    static constexpr std::array<std::string_view, 6> doubles = {"<=", ">=", "==", "!=", "&&", "||"};
    const std::string_view pair = std::string_view(text_).substr(here_, std::min<std::size_t>(2, end_ - here_));
    const char c = at(here_);
    if (std::ranges::find(doubles, pair) != doubles.end())
    {
        emit(pair, here_);
        here_ += 2;
    }
    else if (std::string_view("+-*/^<>?:").find(c) != std::string_view::npos)
    {
        emit(std::string_view(text_).substr(here_, 1), here_);
        ++here_;
    }
    else if (c == '(') { open(nullptr, here_); }
    else if (c == ')') { close(); }
    else if (c == ',')
    {
        if (open_.empty() || open_.back().function == nullptr) { fail(here_, "has a ',' outside of a function"); }
        ++open_.back().values;
        emit(",", here_);
        ++here_;
    }
    else if (c == '=') { fail(here_, "has a '='", "write == to compare"); }
    else if (c == '$') { fail(here_, "has a '$'", "write the name without it"); }
    else if (c == '&' || c == '|') { fail(here_, fmt::format("has a single '{}'", c), "write && or ||"); }
    else
    {
        const bool printable = c > ' ' && c < '\x7f';
        fail(here_, printable ? fmt::format("has the character '{}', which means nothing here", c)
                              : "has a character that means nothing here");
    }
}

std::vector<std::pair<std::size_t, std::size_t>> Reader::splitArguments(std::size_t open) const
{
    std::vector<std::pair<std::size_t, std::size_t>> arguments;
    std::size_t begin = open + 1;
    int depth = 0;
    for (std::size_t position = open; position < end_; ++position)
    {
        const char c = text_[position];
        if (c == '(') { ++depth; }
        if (c == ')') { --depth; }
        if ((c == ',' && depth == 1) || depth == 0)
        {
            arguments.emplace_back(begin, position);
            begin = position + 1;
        }
        if (depth == 0) { return arguments; }
    }
    fail(open, "has a '(' that is never closed");
}

void Reader::readSum(std::size_t begin)
{
    const auto arguments = splitArguments(here_);
    if (arguments.size() != 4) { fail(begin, "has a sum that is not of the form sum(n, 1, 64, ...)"); }
    if (bound_.size() >= deepestSum) { fail(begin, "has its sums nested too deeply"); }

    const std::size_t nameBegin = skipBlanks(arguments[0].first);
    std::size_t nameEnd = nameBegin;
    while (nameEnd < arguments[0].second && (isLetter(text_[nameEnd]) || isDigit(text_[nameEnd]))) { ++nameEnd; }
    const std::string name = text_.substr(nameBegin, nameEnd - nameBegin);
    if (name.empty() || isDigit(name[0]) || skipBlanks(nameEnd) != arguments[0].second)
    {
        fail(nameBegin, "has a sum whose first part is not a name", "write sum(n, 1, 64, ...)");
    }
    if (name == "x" || name == "y" || name == "z" || name == "t" || name == "pi")
    {
        fail(nameBegin, fmt::format("has a sum over '{}', which is taken", name), "sum over n");
    }

    Formula::Sum sum;
    sum.variable = fmt::format("_n{}", generated_++);
    sum.from = read(arguments[1].first, arguments[1].second);
    sum.to = read(arguments[2].first, arguments[2].second);
    bound_.push_back({name, sum.variable});
    sum.term = read(arguments[3].first, arguments[3].second);
    bound_.pop_back();

    for (const Formula* part : {&sum.from, &sum.to, &sum.term})
    {
        result_.usesSpace = result_.usesSpace || part->usesSpace;
        result_.usesTime = result_.usesTime || part->usesTime;
    }
    emit(fmt::format("_s{}()", result_.sums.size()), begin);
    result_.sums.push_back(std::move(sum));
    here_ = arguments[3].second + 1;
}

} // namespace

const std::vector<FormulaFunction>& formulaFunctions()
{
    static const std::vector<FormulaFunction> functions = {
        {"sin", 1},   {"cos", 1},  {"tan", 1},   {"asin", 1},  {"acos", 1},     {"atan", 1},
        {"atan2", 2}, {"sinh", 1}, {"cosh", 1},  {"tanh", 1},  {"exp", 1},      {"log", 1},
        {"sqrt", 1},  {"abs", 1},  {"min", -1},  {"max", -1},  {"erf", 1},      {"pow", 2},
        {"floor", 1}, {"sign", 1}, {"noise", 1}, {"log10", 1}, {"ceil", 1},     {"sqr", 1},
        {"cbrt", 1},  {"mag", 1},  {"hypot", 2}, {"sum", 4},   {"degToRad", 1}, {"radToDeg", 1},
    };
    return functions;
}

Formula readFormula(const std::string& text, const Expression::Constants& constants, const Origin& origin)
{
    if (text.size() > longestFormula)
    {
        throw Error(Fault::input, origin,
                    fmt::format("is a formula of {} characters, but at most {} are read", text.size(), longestFormula),
                    "give parts of it a name in the dictionary");
    }
    return Reader(text, constants, origin).read(0, text.size());
}

Error formulaError(const Origin& origin, const std::string& text, std::size_t position, const std::string& what,
                   const std::string& advice)
{
    constexpr std::size_t shown = 60;
    std::string excerpt = text;
    if (text.size() > shown)
    {
        const std::size_t begin = position > shown / 2 ? position - shown / 2 : 0;
        excerpt = (begin > 0 ? "..." : "") + text.substr(begin, shown) + (begin + shown < text.size() ? "..." : "");
    }
    return Error(Fault::input, origin, fmt::format("\"{}\" {} (character {})", excerpt, what, position + 1), advice);
}

} // namespace isph
