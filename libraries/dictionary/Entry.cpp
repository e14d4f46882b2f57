#include "dictionary/Dictionary.hpp"

#include <cassert>
#include <utility>

namespace isph
{

Entry::Entry(std::string keyword, bool pattern, Origin origin, std::vector<Token> tokens)
    : keyword_(std::move(keyword)), pattern_(pattern), origin_(std::move(origin)), tokens_(std::move(tokens))
{
}

Entry::Entry(std::string keyword, bool pattern, Origin origin, Dictionary dictionary)
    : keyword_(std::move(keyword)),
      pattern_(pattern),
      origin_(std::move(origin)),
      dictionary_(std::make_unique<Dictionary>(std::move(dictionary)))
{
}

Entry::Entry(const Entry& other)
    : usedByMacro(other.usedByMacro),
      isDefault(other.isDefault),
      keyword_(other.keyword_),
      pattern_(other.pattern_),
      origin_(other.origin_),
      tokens_(other.tokens_),
      dictionary_(other.dictionary_ ? std::make_unique<Dictionary>(*other.dictionary_) : nullptr)
{
}

Entry::Entry(Entry&&) noexcept = default;

Entry& Entry::operator=(Entry other)
{
    usedByMacro = other.usedByMacro;
    isDefault = other.isDefault;
    keyword_ = std::move(other.keyword_);
    pattern_ = other.pattern_;
    origin_ = std::move(other.origin_);
    tokens_ = std::move(other.tokens_);
    dictionary_ = std::move(other.dictionary_);
    return *this;
}

Entry::~Entry() = default;

const Dictionary& Entry::dictionary() const
{
    assert(isDictionary());
    return *dictionary_;
}

Dictionary& Entry::dictionary()
{
    assert(isDictionary());
    return *dictionary_;
}

} // namespace isph
