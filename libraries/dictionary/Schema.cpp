#include "dictionary/Schema.hpp"

#include "core/nearestWord.hpp"
#include "dictionary/KeyPattern.hpp"
#include "dictionary/schemaText.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <utility>

namespace isph
{

namespace
{

bool isNameCharacter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Every identifier inside of the strings of a dictionary: what expressions may use as constants.
void collectNames(const Dictionary& dictionary, std::set<std::string, std::less<>>& names)
{
    for (const Entry& entry : dictionary.entries())
    {
        if (entry.isDictionary()) { collectNames(entry.dictionary(), names); }
        for (const Token& token : entry.tokens())
        {
            if (token.kind != Token::Kind::string) { continue; }
            for (std::size_t begin = 0; begin < token.text.size(); ++begin)
            {
                std::size_t end = begin;
                while (end < token.text.size() && isNameCharacter(token.text[end])) { ++end; }
                if (end > begin) { names.insert(token.text.substr(begin, end - begin)); }
                begin = end;
            }
        }
    }
}

/// Whether a dictionary that is left out has defaults to be filled in, and nothing a user must give.
bool hasOnlyDefaults(const std::vector<Key>& keys)
{
    const bool demands = std::ranges::any_of(keys, &Key::required);
    return !demands && std::ranges::any_of(keys, [](const Key& key)
                                           { return key.name != "*" && (key.fallback || hasOnlyDefaults(key.keys)); });
}

/// Completes a dictionary level by level and collects what is wrong.
class Completion
{
public:
    explicit Completion(const Dictionary& dictionary) { collectNames(dictionary, names_); }

    void complete(Dictionary& dictionary, const std::vector<Key>& keys);
    std::vector<Complaint> complaints;

private:
    void checkEntry(Dictionary& dictionary, const Entry& entry, const std::vector<Key>& keys);
    void checkValue(const Dictionary& dictionary, const Entry& entry, const Key& key);
    void checkNumber(const Entry& entry, const Key& key, double value);
    void addDefault(Dictionary& dictionary, const Key& key);
    void complain(const Entry& entry, std::string what, std::string advice = "")
    {
        complaints.push_back({entry.origin(), std::move(what), std::move(advice)});
    }

    std::set<std::string, std::less<>> names_;
};

void Completion::complete(Dictionary& dictionary, const std::vector<Key>& keys)
{
    for (const Key& key : keys)
    {
        if (key.name == "*" || dictionary.has(key.name)) { continue; }
        const bool isDictionary = key.type == Key::Type::dictionary;
        if (key.fallback || (isDictionary && !key.required && hasOnlyDefaults(key.keys)))
        {
            addDefault(dictionary, key);
        }
        else if (key.required)
        {
            Origin origin = dictionary.origin();
            origin.entry = dictionary.scopedName(key.name);
            complaints.push_back({std::move(origin), "is missing", fmt::format("write {}", usage(key))});
        }
    }
    // By index: checking an entry completes the dictionaries inside of it, but adds none here.
    for (std::size_t i = 0; i < dictionary.entries().size(); ++i)
    {
        checkEntry(dictionary, dictionary.entries()[i], keys);
    }
}

void Completion::addDefault(Dictionary& dictionary, const Key& key)
{
    const Origin origin{dictionary.origin().file, 0, dictionary.scopedName(key.name)};
    if (key.type == Key::Type::dictionary)
    {
        Dictionary inner(origin);
        if (key.fallback)
        {
            const Dictionary parsed = Dictionary::parse(fmt::format("{} {}", key.name, *key.fallback), origin.file, "");
            for (Entry entry : parsed.dictionary(key.name).entries())
            {
                entry.isDefault = true;
                inner.set(std::move(entry));
            }
        }
        Entry entry(key.name, false, origin, std::move(inner));
        entry.isDefault = true;
        dictionary.set(std::move(entry));
        return;
    }
    const Dictionary parsed = Dictionary::parse(fmt::format("{} {};", key.name, *key.fallback), origin.file, "");
    Entry entry(key.name, false, origin, parsed.find(key.name)->tokens());
    entry.isDefault = true;
    dictionary.set(std::move(entry));
}

void Completion::checkEntry(Dictionary& dictionary, const Entry& entry, const std::vector<Key>& keys)
{
    if (entry.keyword() == "FoamFile") { return; }
    std::vector<const Key*> meant;
    if (entry.isPattern())
    {
        const KeyPattern pattern(entry.keyword());
        for (const Key& key : keys)
        {
            if (key.name == "*" || pattern.matches(key.name)) { meant.push_back(&key); }
        }
    }
    else
    {
        auto key = std::ranges::find(keys, entry.keyword(), &Key::name);
        if (key == keys.end()) { key = std::ranges::find(keys, "*", &Key::name); }
        if (key != keys.end()) { meant.push_back(&*key); }
    }
    if (meant.empty())
    {
        if (entry.usedByMacro || names_.contains(entry.keyword())) { return; }
        std::vector<std::string> known;
        for (const Key& key : keys) { known.push_back(key.name); }
        const auto nearest = nearestWord(entry.keyword(), known);
        complain(entry, "is not a known entry",
                 nearest ? fmt::format("did you mean '{}'?", *nearest)
                         : fmt::format("known are: {}", listOfWords(entry.keyword(), known)));
        return;
    }
    for (const Key* key : meant)
    {
        if (key->type != Key::Type::dictionary)
        {
            checkValue(dictionary, entry, *key);
            continue;
        }
        if (!entry.isDictionary())
        {
            complain(entry, fmt::format("is {} but must be a dictionary {{ ... }}", shownValue(entry)));
            continue;
        }
        complete(dictionary.find(entry.keyword())->dictionary(), key->keys);
    }
}

void Completion::checkValue(const Dictionary& dictionary, const Entry& entry, const Key& key)
{
    const std::string& name = entry.keyword();
    const std::vector<Token>& tokens = entry.tokens();
    const bool oneWord = tokens.size() == 1 && tokens[0].kind == Token::Kind::word;
    const bool chosen = oneWord && std::ranges::find(key.words, tokens[0].text) != key.words.end();
    const bool isNumber = key.type == Key::Type::number || key.type == Key::Type::integer;
    if (isNumber && chosen) { return; }
    if (isNumber && oneWord && !key.words.empty())
    {
        complain(entry, fmt::format("is {} but must be {}", tokens[0].text, shape(key)), hint(key));
        return;
    }
    try
    {
        switch (key.type)
        {
        case Key::Type::number:
            checkNumber(entry, key, dictionary.number(name));
            break;
        case Key::Type::integer:
            checkNumber(entry, key, dictionary.integer(name));
            break;
        case Key::Type::flag:
            dictionary.flag(name);
            break;
        case Key::Type::text:
            dictionary.text(name);
            break;
        case Key::Type::vector:
            dictionary.vector(name);
            break;
        case Key::Type::word:
            if (dictionary.word(name); !key.words.empty() && !chosen)
            {
                complain(entry, fmt::format("'{}' is not a known choice", tokens[0].text),
                         fmt::format("known are: {}", listOfWords(tokens[0].text, key.words)));
            }
            break;
        case Key::Type::dimensioned:
            if (const auto value = scalarValue(entry)) { checkNumber(entry, key, *value); }
            else { complain(entry, fmt::format("is {} but must be {}", shownValue(entry), shape(key)), hint(key)); }
            break;
        case Key::Type::list:
        case Key::Type::function:
        {
            const bool list = tokens.size() >= 2 && tokens.front().text == "(" && tokens.back().text == ")";
            const bool spelled =
                !tokens.empty() && (tokens[0].kind == Token::Kind::number || tokens[0].text == "uniform" ||
                                    tokens[0].text == "expression" || tokens[0].text == "table");
            if (!list && (key.type == Key::Type::list || !spelled))
            {
                complain(entry, fmt::format("is {} but must be {}", shownValue(entry), shape(key)), hint(key));
            }
            break;
        }
        case Key::Type::dictionary:
        case Key::Type::any:
            break;
        }
    }
    catch (const Error& error)
    {
        complaints.insert(complaints.end(), error.complaints().begin(), error.complaints().end());
    }
}

void Completion::checkNumber(const Entry& entry, const Key& key, double value)
{
    if (key.positive && !(value > 0)) { complain(entry, fmt::format("is {} but must be positive", value), hint(key)); }
    else if (value < key.minimum)
    {
        complain(entry, fmt::format("is {} but must be at least {}", value, key.minimum), hint(key));
    }
    else if (value > key.maximum)
    {
        complain(entry, fmt::format("is {} but must be at most {}", value, key.maximum), hint(key));
    }
}

} // namespace

Schema::Schema(std::string name, std::vector<Key> keys) : name_(std::move(name)), keys_(std::move(keys)) {}

Dictionary Schema::complete(const Dictionary& dictionary) const
{
    Dictionary completed = dictionary;
    Completion completion(dictionary);
    completion.complete(completed, keys_);
    if (!completion.complaints.empty()) { throw Error(Fault::input, std::move(completion.complaints)); }
    return completed;
}

std::string Schema::annotated() const { return annotatedText(name_, keys_); }

} // namespace isph
