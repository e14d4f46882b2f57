#include "prepareRun.hpp"

#include "core/nearestWord.hpp"
#include "core/version.hpp"
#include "core/writeTextFile.hpp"
#include "dictionary/readText.hpp"
#include "dictionary/TextEditor.hpp"
#include "dictionary/writeDictionary.hpp"
#include "RunRecord.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace isph
{

namespace fs = std::filesystem;

namespace
{

void setEntries(TextEditor& editor, const std::string& prefix, const Dictionary& entries)
{
    for (const Entry& entry : entries.entries())
    {
        const std::string key = prefix + (entry.isPattern() ? fmt::format("\"{}\"", entry.keyword()) : entry.keyword());
        const Entry* existing = editor.dictionary().findScoped(prefix + entry.keyword());
        const bool deeper = entry.isDictionary() && existing != nullptr && existing->isDictionary() &&
                            !entry.dictionary().entries().empty();
        if (deeper) { setEntries(editor, key + ".", entry.dictionary()); }
        else
        {
            try
            {
                editor.set(key, valueText(entry));
            }
            catch (const Error& error)
            {
                const Complaint& complaint = error.complaints().front();
                throw Error(Fault::input, entry.origin(),
                            fmt::format("{}: {}", toString(complaint.origin), complaint.what), complaint.advice);
            }
        }
    }
}

/// The text of a run's file with its entries set.
std::string changedText(const Run& run, const fs::path& folder, const Entry& file)
{
    const std::string& name = file.keyword();
    std::string text;
    if (const Entry* replaced = run.replacements.find(name); replaced != nullptr && replaced->isDictionary())
    {
        text = foamHeader("dictionary", fs::path(name).filename().string()) + dictionaryText(replaced->dictionary());
    }
    else
    {
        if (!fs::is_regular_file(folder / name))
        {
            throw Error(Fault::input, file.origin(), fmt::format("the base case has no file {}", name),
                        "name a file like \"system/schemes\"");
        }
        text = readText(folder / name, {name, 0, ""});
    }
    TextEditor editor(text, name, (folder / name).parent_path());
    setEntries(editor, "", file.dictionary());
    return editor.text();
}

/// Every file that a run changes with its new text.
std::vector<std::pair<std::string, std::string>> changedFiles(const Run& run, const fs::path& folder)
{
    std::vector<std::pair<std::string, std::string>> files;
    for (const Entry& file : run.replacements.entries())
    {
        Entry empty(file.keyword(), file.isPattern(), file.origin(), Dictionary(file.origin()));
        if (run.settings.find(file.keyword()) == nullptr)
        {
            files.emplace_back(file.keyword(), changedText(run, folder, empty));
        }
    }
    for (const Entry& file : run.settings.entries())
    {
        files.emplace_back(file.keyword(), changedText(run, folder, file));
    }
    return files;
}

/// Whether the dictionary of a run holds a name below a key; no answer if there is no such dictionary to look into.
void checkNamed(const Quantity& quantity, const Dictionary& dictionary, const char* key, const char* family)
{
    if (!dictionary.hasDictionary(key)) { return; }
    std::vector<std::string> names;
    for (const Entry& entry : dictionary.dictionary(key).entries()) { names.push_back(entry.keyword()); }
    if (dictionary.dictionary(key).find(quantity.from) == nullptr)
    {
        throwUnknownWord(family, Word{quantity.from, quantity.origin}, names);
    }
}

void append(std::string& text, const fs::path& file)
{
    text += fmt::format("{}\n{}\n", file.filename().string(), readText(file, {file.string(), 0, ""}));
}

} // namespace

void applySettings(const Run& run, const fs::path& folder)
{
    for (const auto& [file, text] : changedFiles(run, folder)) { writeTextFile(folder / file, text); }
}

void checkRun(const Run& run, const Sweep& sweep)
{
    const auto files = changedFiles(run, sweep.baseCase);
    const auto dictionary = [&](const std::string& name) -> std::optional<Dictionary>
    {
        const auto found = std::ranges::find(files, name, [](const auto& file) { return file.first; });
        const fs::path folder = (sweep.baseCase / name).parent_path();
        if (found != files.end()) { return Dictionary::parse(found->second, name, folder); }
        if (!fs::is_regular_file(sweep.baseCase / name)) { return std::nullopt; }
        return Dictionary::read(sweep.baseCase / name, name);
    };
    const std::optional<Dictionary> control = dictionary("system/controlDict");
    const std::optional<Dictionary> sample = dictionary("system/sampleDict");
    for (const Quantity& quantity : run.quantities)
    {
        const bool ofFunction = quantity.source == Quantity::Source::function;
        const bool ofLine = quantity.source == Quantity::Source::line;
        if (ofFunction && control) { checkNamed(quantity, *control, "functions", "function"); }
        if (ofLine && sample) { checkNamed(quantity, *sample, "lines", "line"); }
    }
}

std::string baseHash(const Sweep& sweep)
{
    std::vector<fs::path> files;
    const bool makesLattice = std::ranges::any_of(sweep.commands, [](const std::string& command)
                                                  { return command.starts_with("makeLattice"); });
    for (const char* folder : {"0", "0.orig", "constant", "system"})
    {
        if (!fs::is_directory(sweep.baseCase / folder)) { continue; }
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(sweep.baseCase / folder))
        {
            const std::string name = entry.path().filename().string();
            const bool ours = name == "workPrecisionDict" || (name == "lattice" && makesLattice);
            if (entry.is_regular_file() && !ours) { files.push_back(entry.path()); }
        }
    }
    for (const auto* commands : {&sweep.commands, &sweep.after})
    {
        for (const std::string& command : *commands)
        {
            const fs::path script = sweep.baseCase / wordsOf(command).front();
            if (fs::is_regular_file(script)) { files.push_back(script); }
        }
    }
    std::ranges::sort(files);
    std::string text;
    for (const fs::path& file : files)
    {
        // Fields of a run may be too large for a text: their size stands for them.
        if (fs::file_size(file) <= largestText) { append(text, file); }
        else { text += fmt::format("{} {}\n", file.string(), fs::file_size(file)); }
    }
    return hashOf(text);
}

std::string settingsHash(const Run& run, const Sweep& sweep, const std::string& baseFiles)
{
    std::string text = fmt::format("{}\n{}\n{}\n", version, baseFiles, sweep.threads);
    for (const std::string& command : sweep.commands) { text += command + '\n'; }
    for (const std::string& command : sweep.after) { text += "after " + command + '\n'; }
    return hashOf(text + dictionaryText(run.settings) + dictionaryText(run.replacements));
}

std::vector<std::string> wordsOf(const std::string& command)
{
    std::vector<std::string> words;
    bool open = false;
    char quote = '\0';
    for (const char c : command)
    {
        if (quote == '\0' && (c == ' ' || c == '\t'))
        {
            open = false;
            continue;
        }
        if (!open) { words.emplace_back(); }
        open = true;
        if (quote == '\0' && (c == '\'' || c == '"')) { quote = c; }
        else if (c == quote) { quote = '\0'; }
        else { words.back() += c; }
    }
    return words.empty() ? std::vector<std::string>{""} : words;
}

} // namespace isph
