// etc/annotated is written by hand for its reader; these tests keep it true to the schemas.

#include "case/readTimeControl.hpp"
#include "flow/readFlowSettings.hpp"
#include "flow/readFluid.hpp"
#include "functions/functionSelection.hpp"
#include "functions/readFunctions.hpp"
#include "lattice/readLattice.hpp"
#include "sampling/readSampleSet.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <sstream>

namespace isph
{

namespace
{

struct Annotated
{
    std::string name;
    Schema schema;
};

std::string textOf(const std::string& name)
{
    std::ifstream file(std::string(ANNOTATED) + "/" + name);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

bool mentions(const std::string& text, const std::string& word)
{
    return std::regex_search(text, std::regex("\\b" + word + "\\b"));
}

void expectMentioned(const std::vector<Key>& keys, const std::string& text)
{
    for (const Key& key : keys)
    {
        if (key.name != "*") { EXPECT_TRUE(mentions(text, key.name)) << key.name; }
        for (const std::string& word : key.words) { EXPECT_TRUE(mentions(text, word)) << key.name << ": " << word; }
        expectMentioned(key.keys, text);
    }
}

std::vector<std::string> textsOf(const std::vector<Token>& tokens)
{
    std::vector<std::string> texts;
    for (const Token& token : tokens) { texts.push_back(token.text); }
    return texts;
}

/// What is written beside a key that has a default is that default.
void expectDefaults(const std::vector<Key>& keys, const Dictionary& dictionary)
{
    for (const Key& key : keys)
    {
        const Entry* entry = dictionary.find(key.name);
        if (key.name == "*" || entry == nullptr) { continue; }
        if (entry->isDictionary()) { expectDefaults(key.keys, entry->dictionary()); }
        else if (key.fallback)
        {
            const Dictionary expected = Dictionary::parse(key.name + " " + *key.fallback + ";", "default");
            EXPECT_EQ(textsOf(entry->tokens()), textsOf(expected.find(key.name)->tokens())) << key.name;
        }
    }
}

/// Shows the name where googletest would show bytes.
void PrintTo(const Annotated& annotated, std::ostream* stream) { *stream << annotated.name; }

class AnnotatedDictionaries : public testing::TestWithParam<Annotated>
{
};

} // namespace

TEST_P(AnnotatedDictionaries, HaveEveryKeyWithItsDefault)
{
    const auto& [name, schema] = GetParam();
    const Dictionary dictionary = Dictionary::read(std::string(ANNOTATED) + "/" + name);
    EXPECT_NO_THROW(schema.complete(dictionary));
    expectMentioned(schema.keys(), textOf(name));
    expectDefaults(schema.keys(), dictionary);
}

INSTANTIATE_TEST_SUITE_P(Schemas, AnnotatedDictionaries,
                         testing::Values(Annotated{"latticeDict", latticeDictSchema()},
                                         Annotated{"controlDict", controlDictSchema()},
                                         Annotated{"schemes", schemesSchema()}, Annotated{"solution", solutionSchema()},
                                         Annotated{"sampleDict", sampleSchema()},
                                         Annotated{"transportProperties", transportPropertiesSchema()}),
                         [](const auto& instance) { return instance.param.name; });

TEST(AnnotatedFunctions, HaveEveryTypeAndKey)
{
    const std::string text = textOf("controlDict");
    for (const ListedWord& type : functionTypes()) { EXPECT_TRUE(mentions(text, type.name)) << type.name; }
    expectMentioned(functionKeys(), text);
    for (const FunctionType* type : {&errorNormsType, &flowStatisticsType, &sampleLinesType, &probesType,
                                     &fieldAverageType, &timingType, &wallProfileType, &forcesType})
    {
        expectMentioned(type->keys(), text);
    }
}

} // namespace isph
