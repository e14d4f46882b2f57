#include "caseFields/storedFieldText.hpp"

#include "dictionary/writeDictionary.hpp"

#include <regex>
#include <set>

namespace isph
{

namespace
{

/// Every name in the expressions of a dictionary and those below it.
void collectNames(const Dictionary& dictionary, std::set<std::string>& names)
{
    static const std::regex name("[A-Za-z_][A-Za-z0-9_]*");
    for (const Entry& entry : dictionary.entries())
    {
        if (entry.isDictionary()) { collectNames(entry.dictionary(), names); }
        for (const Token& token : entry.tokens())
        {
            if (token.kind != Token::Kind::string) { continue; }
            names.insert(std::sregex_token_iterator(token.text.begin(), token.text.end(), name),
                         std::sregex_token_iterator());
        }
    }
}

/// The boundary conditions without the entries that only macros read: their values stand where they were used.
Dictionary conditionsOf(const Dictionary& boundary, const std::set<std::string>& names)
{
    Dictionary conditions(boundary.origin());
    for (const Entry& entry : boundary.entries())
    {
        if (entry.isDictionary() || !entry.usedByMacro || names.contains(entry.keyword())) { conditions.set(entry); }
    }
    return conditions;
}

} // namespace

std::string storedFieldText(const Dictionary& field, const std::string& name, int components)
{
    std::set<std::string> names;
    if (field.hasDictionary("boundaryField")) { collectNames(field.dictionary("boundaryField"), names); }

    Dictionary stored(field.origin());
    for (const Entry& entry : field.entries())
    {
        if (entry.keyword() == "boundaryField" && entry.isDictionary())
        {
            stored.set(Entry(entry.keyword(), false, entry.origin(), conditionsOf(entry.dictionary(), names)));
        }
        else if (entry.keyword() == "internalField")
        {
            stored.set(Entry(entry.keyword(), false, entry.origin(),
                             {{Token::Kind::word, "hdf5"}, {Token::Kind::string, "fields.h5"}}));
        }
        else if (entry.keyword() == "dimensions" || (!entry.isDictionary() && names.contains(entry.keyword())))
        {
            stored.set(entry);
        }
    }
    return foamHeader(components == 1 ? "latticeScalarField" : "latticeVectorField", name) + dictionaryText(stored);
}

} // namespace isph
