#pragma once

#include "Sweep.hpp"

namespace isph
{

/// The text of system/workPrecisionDict, which is read once for each run, with the run's parameters in place of their
/// macros ($N).
class SweepText
{
public:
    /// \param reduced lay the dictionary `reduced` over the rest
    /// \throws Error(input) if the file is missing or breaks the grammar, or if a parameter is none.
    SweepText(const std::filesystem::path& file, std::string shownAs, bool reduced);

    /// The lists of `parameters`. What is read of the text is that dictionary and what stands before it.
    const std::vector<Parameter>& parameters() const { return parameters_; }

    /// The dictionary with these values of the parameters: an entry of the same name at the top of the text is
    /// replaced, one that is missing is put in front of everything.
    Dictionary with(const std::vector<std::string>& values) const;

    /// Whether the text has a macro of this name: $N, ${N}.
    bool uses(const std::string& name) const;

private:
    std::string text_;
    std::string shownAs_;
    std::filesystem::path folder_;
    bool reduced_;
    std::vector<Parameter> parameters_;
};

/// The parameters of a dictionary: name (v1 v2 ...); or name { values (v1 v2 ...); entry file.entry; }.
/// \throws Error(input) naming the entry.
std::vector<Parameter> readParameters(const Dictionary& dictionary);

} // namespace isph
