// Hostile dictionaries: whatever the text, reading it ends soon, with a dictionary or with an Error.
//
// What reads also has to write and read back, to be completed by a schema, to be edited, and its strings are evaluated
// as expressions. Nothing outside of the text is read: including is off, and tables are left alone.

#include "dictionary/Schema.hpp"
#include "dictionary/SpaceTimeFunction.hpp"
#include "dictionary/TextEditor.hpp"
#include "dictionary/writeDictionary.hpp"
#include "expression/Expression.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace isph
{
namespace
{

Schema schema()
{
    using T = Key::Type;
    std::vector<Key> values = {
        {.name = "order", .type = T::integer, .fallback = "10", .minimum = 2},
        {.name = "size", .type = T::number, .fallback = "1.5", .words = {"auto"}, .positive = true},
        {.name = "type", .type = T::word, .required = true, .words = {"wall", "periodic"}},
        {.name = "flag", .type = T::flag, .fallback = "no"},
        {.name = "title", .type = T::text},
        {.name = "origin", .type = T::vector},
        {.name = "fields", .type = T::list},
        {.name = "nu", .type = T::dimensioned},
        {.name = "value", .type = T::function},
        {.name = "any"},
    };
    std::vector<Key> keys = values;
    keys.push_back({.name = "kernel", .type = T::dictionary, .required = true, .keys = values});
    keys.push_back(
        {.name = "patches", .type = T::dictionary, .keys = {{.name = "*", .type = T::dictionary, .keys = values}}});
    return Schema("fuzz", std::move(keys));
}

/// Runs a step that may refuse its input, but only by an Error.
template<class Step>
void mayRefuse(const Step& step)
{
    try
    {
        step();
    }
    catch (const Error& error)
    {
        if (error.complaints().empty() || std::string(error.what()).empty()) { std::abort(); }
    }
}

void evaluateStrings(const Dictionary& dictionary, int& evaluations)
{
    for (const Entry& entry : dictionary.entries())
    {
        if (entry.isDictionary()) { evaluateStrings(entry.dictionary(), evaluations); }
        for (const Token& token : entry.tokens())
        {
            if (token.kind != Token::Kind::string || --evaluations < 0) { continue; }
            mayRefuse(
                [&]
                {
                    const auto constant = [&dictionary](const std::string& name) { return dictionary.constant(name); };
                    const Expression expression(token.text, constant, entry.origin());
                    static_cast<void>(expression(0.5, 0.25, -1, 2));
                });
        }
        const bool table = !entry.tokens().empty() && entry.tokens()[0].text == "table";
        if (!table && --evaluations >= 0)
        {
            mayRefuse([&] { readFunction(dictionary, entry.keyword(), 3, {}, ""); });
            mayRefuse([&] { static_cast<void>(dictionary.dimensionedNumber(entry.keyword(), {})); });
            mayRefuse([&] { static_cast<void>(dictionary.words(entry.keyword())); });
        }
    }
}

void readHostileText(const std::string& text)
{
    static const Schema checks = schema();
    // As an expression of its own, and as a dictionary.
    mayRefuse([&] { static_cast<void>(Expression(text, {}, Origin{"fuzz", 1, "e"})(0.5, 0.25, -1, 2)); });
    mayRefuse(
        [&]
        {
            const Dictionary dictionary = Dictionary::parse(text, "fuzz", "");
            mayRefuse([&] { static_cast<void>(checks.complete(dictionary)); });
            int evaluations = 20;
            evaluateStrings(dictionary, evaluations);

            std::string written;
            mayRefuse([&] { written = dictionaryText(dictionary); });
            if (!written.empty() && dictionaryText(Dictionary::parse(written, "written", "")) != written)
            {
                std::abort();
            }
            mayRefuse([&] { TextEditor(text, "fuzz", "").set("order", "4"); });
            mayRefuse([&] { TextEditor(text, "fuzz", "").set("kernel.type", "{ a 1; }"); });
            mayRefuse([&] { TextEditor(text, "fuzz", "").remove("kernel/order"); });
        });
}

} // namespace
} // namespace isph

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    isph::readHostileText(std::string(data, data + size));
    return 0;
}
