// caseDict: reads and changes entries of a dictionary.
//
//   caseDict system/controlDict -entry endTime -value
//   caseDict system/controlDict -entry endTime -set 2
//   caseDict 0/U -entry 'boundaryField.lid' -add '{ type noSlip; }'
//   caseDict system/schemes -entry kernel/order -remove
//   caseDict system/schemes -expand
//
// Changes are made in the text: comments and layout stay. The file is replaced in one go, or not at all.

#include "core/runApplication.hpp"
#include "core/writeTextFile.hpp"
#include "dictionary/readText.hpp"
#include "dictionary/TextEditor.hpp"
#include "dictionary/writeDictionary.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iostream>

using namespace isph;

/// The one action that was asked for; empty: to print.
static std::string_view action(const CommandLine& line)
{
    static constexpr std::array<std::string_view, 6> actions = {"set", "add", "remove", "value", "keywords", "expand"};
    std::string_view chosen;
    for (const std::string_view candidate : actions)
    {
        if (!line.has(candidate)) { continue; }
        if (!chosen.empty())
        {
            throw Error(Fault::usage, fmt::format("-{} and -{} exclude each other", chosen, candidate));
        }
        chosen = candidate;
    }
    return chosen;
}

/// The whole dictionary, macros and directives expanded, header first.
static std::string expanded(const Dictionary& dictionary)
{
    Dictionary headed;
    if (const Entry* header = dictionary.find("FoamFile")) { headed.set(*header); }
    const std::string text = headed.entries().empty() ? "" : "FoamFile\n" + valueText(headed.entries()[0]) + "\n\n";
    return text + dictionaryText(dictionary);
}

static void print(const TextEditor& editor, const std::string& key, std::string_view asked)
{
    if (key.empty() && asked != "keywords")
    {
        if (asked == "value") { throw Error(Fault::usage, "-value needs an -entry"); }
        std::cout << (asked == "expand" ? expanded(editor.dictionary()) : editor.text());
        return;
    }
    if (asked == "keywords")
    {
        const Entry* entry = key.empty() ? nullptr : &editor.entry(key);
        if (entry != nullptr && !entry->isDictionary())
        {
            throw Error(Fault::input, entry->origin(), fmt::format("is {} and has no keywords", shownValue(*entry)));
        }
        for (const Entry& inner : (entry != nullptr ? entry->dictionary() : editor.dictionary()).entries())
        {
            std::cout << (inner.isPattern() ? '"' + inner.keyword() + '"' : inner.keyword()) << '\n';
        }
        return;
    }
    const Entry& entry = editor.entry(key);
    if (asked == "value")
    {
        std::cout << valueText(entry) << '\n';
        return;
    }
    Dictionary alone;
    alone.set(entry);
    std::cout << dictionaryText(alone);
}

static void run(const CommandLine& line, Log&)
{
    if (line.positional().size() != 1)
    {
        throw Error(Fault::usage, fmt::format("{} dictionaries are given, but one is needed", line.positional().size()),
                    "e.g. caseDict system/controlDict -keywords");
    }
    const std::string& name = line.positional()[0];
    const std::filesystem::path file = line.caseDirectory() / name;
    const std::string key = line.value("entry").value_or("");
    const std::string_view asked = action(line);

    const std::filesystem::path folder = file.parent_path().empty() ? "." : file.parent_path();
    TextEditor editor(readText(file, Origin{name, 0, ""}), name, folder);
    if (asked != "set" && asked != "add" && asked != "remove")
    {
        print(editor, key, asked);
        return;
    }
    if (key.empty()) { throw Error(Fault::usage, fmt::format("-{} needs an -entry", asked), "e.g. -entry endTime"); }
    if (asked == "set") { editor.set(key, *line.value("set")); }
    else if (asked == "add") { editor.add(key, *line.value("add")); }
    else { editor.remove(key); }
    writeTextFile(file, editor.text());
}

int main(int argc, char** argv)
{
    const Application application{
        .name = "caseDict",
        .summary = "Reads and changes entries of a dictionary; comments and layout stay as they are.",
        .examples = "caseDict system/controlDict -entry endTime -value\n"
                    "caseDict system/controlDict -entry endTime -set 2\n"
                    "caseDict 0/U -entry boundaryField.lid -add '{ type noSlip; }'\n"
                    "caseDict system/schemes -entry kernel/order -remove\n"
                    "caseDict system/schemes -expand\n",
        .options = {{"entry", "KEY", "the entry, scoped by dots or slashes: kernel.order"},
                    {"value", "", "print its value only"},
                    {"keywords", "", "print the keywords of the dictionary, or of the entry"},
                    {"expand", "", "print with all macros and directives expanded"},
                    {"set", "VALUE", "give the entry this value; added if it is not there"},
                    {"add", "VALUE", "add the entry; an error if it is there"},
                    {"remove", "", "remove the entry"}},
        .positional = "DICTIONARY",
        .banner = false,
    };
    return runApplication(application, argc, argv, run);
}
