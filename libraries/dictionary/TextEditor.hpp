#pragma once

#include "dictionary/Dictionary.hpp"
#include "dictionary/TextSpan.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isph
{

/// Changes entries in the text of a dictionary and leaves everything else, comments and layout included, as it is.
///
/// Keys are scoped, "kernel.order" or "kernel/order"; a part in quotes is a pattern: boundaryField."x(Min|Max)".type.
/// After every change the text is read again: a change that would not parse, or would not be seen (#inputMode protect,
/// say), throws Error(input) and is not made.
class TextEditor
{
public:
    /// \param folder what #include is relative to
    /// \throws Error(input) if the text does not parse.
    TextEditor(std::string text, std::string shownAs, std::filesystem::path folder);

    /// Gives an entry another value, "2", "(1 0 0)" or "{ a 1; }"; adds the entry if there is none.
    /// \throws Error(input) if the dictionary that it would be in does not exist.
    void set(const std::string& key, const std::string& value);

    /// \throws Error(input) if there is one already.
    void add(const std::string& key, const std::string& value);

    /// Removes an entry, wherever it is given in this text.
    /// \throws Error(input) if there is none, or if it comes from an included file or a macro.
    void remove(const std::string& key);

    const std::string& text() const { return text_; }
    const Dictionary& dictionary() const { return dictionary_; }

    /// The entry of a scoped key, for reading.
    /// \throws Error(input) naming the nearest key if there is none.
    const Entry& entry(const std::string& key) const;

private:
    static std::optional<std::vector<SpanName>> resolve(const Dictionary& scope, std::span<const std::string> parts);
    std::vector<SpanName> namesOf(const std::string& key) const;
    const TextSpan* spanOf(const std::string& key, const std::vector<const TextSpan*>& spans) const;
    void insert(const std::string& key, const std::vector<SpanName>& names, const TextSpan& root,
                const std::string& value);
    std::string inserted(const TextSpan& block, bool whole, const std::string& key, const std::string& value) const;
    void replace(std::string text, const std::string& key, bool expected);

    std::string text_;
    std::string shownAs_;
    std::filesystem::path folder_;
    Dictionary dictionary_;
};

} // namespace isph
