#pragma once

#include "dictionary/Dictionary.hpp"
#include "dictionary/Schema.hpp"
#include "sampling/SampleSet.hpp"

#include <optional>
#include <string>
#include <vector>

namespace isph
{

/// What a command line may put in place of entries of the dictionary.
struct SampleChoices
{
    std::optional<std::vector<Word>> fields;
    std::optional<Word> interpolation;
    std::optional<Word> only; ///< name of the one line or plane to sample
};

/// The lines and planes that system/sampleDict asks for.
/// \throws Error(input) at the entry: a line that leaves the box or has no length, two places of the same name, ...
SampleSet readSampleSet(const Dictionary& sampleDict, const Lattice& lattice, const SampleChoices& choices = {});

const Schema& sampleSchema();

/// The plane of a word like "z", "z 0.5" or "auto", for a look without a dictionary: without a position the middle of
/// the box, auto a plane across the axis that is left out, else across z. Its name is "plane".
/// \throws Error(usage) if the text is none.
Plane planeOfText(const std::string& text, const Lattice& lattice);

} // namespace isph
