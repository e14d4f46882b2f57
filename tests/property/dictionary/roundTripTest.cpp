#include "dictionary/Dictionary.hpp"
#include "dictionary/TextEditor.hpp"
#include "dictionary/writeDictionary.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <random>

namespace isph
{
namespace
{

/// Random dictionaries, the same for the same seed.
class Draw
{
public:
    explicit Draw(unsigned seed) : random_(seed) {}

    Dictionary dictionary(int depth)
    {
        Dictionary result;
        for (int i = upTo(8); i > 0; --i)
        {
            const bool pattern = upTo(5) == 0;
            const std::string keyword = pattern ? string("abcxyz.*+?|[]_") : word();
            if (depth > 0 && upTo(3) == 0) { result.set(Entry(keyword, pattern, {}, dictionary(depth - 1))); }
            else { result.set(Entry(keyword, pattern, {}, tokens())); }
        }
        return result;
    }

    int upTo(int largest) { return std::uniform_int_distribution<int>(0, largest)(random_); }

private:
    std::string string(std::string_view letters)
    {
        std::string result;
        for (int i = 1 + upTo(12); i > 0; --i)
        {
            result += letters[static_cast<std::size_t>(upTo(static_cast<int>(letters.size()) - 1))];
        }
        return result;
    }

    std::string word()
    {
        std::string result = "k";
        result += string("abcXYZ0123456789_.-+:,*<>=!?@#$%&^~|");
        if (upTo(4) == 0) { result.append("(").append(string("Up.,")).append(")"); }
        return result;
    }

    double number()
    {
        // All bit patterns that are finite numbers, and the kind that people write.
        if (upTo(1) == 0) { return upTo(2000) / 8.0 - 100; }
        const double any = std::bit_cast<double>(std::uniform_int_distribution<std::uint64_t>()(random_));
        return std::isfinite(any) ? any : 0.1;
    }

    std::vector<Token> tokens()
    {
        std::vector<Token> result;
        std::string open;
        for (int i = upTo(10); i > 0; --i)
        {
            switch (upTo(4))
            {
            case 0:
                result.push_back({Token::Kind::word, word()});
                break;
            case 1:
                result.push_back({Token::Kind::string, string("ab \"\n;{}()/*$#.\\\xC3\xA9") + "e"});
                break;
            case 2:
                result.push_back({Token::Kind::number, "", number()});
                break;
            case 3:
                open += upTo(1) == 0 ? ')' : ']';
                result.push_back({Token::Kind::bracket, open.back() == ')' ? "(" : "["});
                break;
            default:
                if (open.empty()) { break; }
                result.push_back({Token::Kind::bracket, std::string(1, open.back())});
                open.pop_back();
            }
        }
        for (; !open.empty(); open.pop_back())
        {
            result.push_back({Token::Kind::bracket, std::string(1, open.back())});
        }
        return result;
    }

    std::mt19937 random_;
};

/// Random patterns are not always regular expressions, and a backslash before a quote cannot be written.
bool isHonest(const Error& error)
{
    const std::string message = error.what();
    return message.find("is not a regular expression") != std::string::npos ||
           (message.find("which no dictionary can hold") != std::string::npos &&
            message.find('\\') != std::string::npos);
}

bool sameToken(const Token& a, const Token& b)
{
    const bool number = a.kind == Token::Kind::number;
    return a.kind == b.kind &&
           (number ? std::bit_cast<std::uint64_t>(a.number) == std::bit_cast<std::uint64_t>(b.number)
                   : a.text == b.text);
}

void expectSame(const Dictionary& a, const Dictionary& b)
{
    ASSERT_EQ(a.entries().size(), b.entries().size());
    for (std::size_t i = 0; i < a.entries().size(); ++i)
    {
        const Entry& left = a.entries()[i];
        const Entry& right = b.entries()[i];
        ASSERT_EQ(left.keyword(), right.keyword());
        ASSERT_EQ(left.isPattern(), right.isPattern());
        ASSERT_EQ(left.isDictionary(), right.isDictionary());
        if (left.isDictionary()) { expectSame(left.dictionary(), right.dictionary()); }
        ASSERT_TRUE(std::ranges::equal(left.tokens(), right.tokens(), sameToken)) << left.keyword();
    }
}

TEST(Dictionary, ReadsBackAsItWasWritten)
{
    int compared = 0;
    for (unsigned seed = 0; seed < 2000; ++seed)
    {
        const Dictionary drawn = Draw(seed).dictionary(4);
        std::string text;
        Dictionary read;
        try
        {
            text = dictionaryText(drawn);
            read = Dictionary::parse(text, "drawn", "");
        }
        catch (const Error& error)
        {
            ASSERT_TRUE(isHonest(error)) << "seed " << seed << ": " << error.what() << '\n' << text;
            continue;
        }
        SCOPED_TRACE(seed);
        expectSame(drawn, read);
        EXPECT_EQ(dictionaryText(read), text);
        if (HasFatalFailure()) { return; }
        ++compared;
    }
    EXPECT_GT(compared, 500);
}

TEST(Dictionary, IsNotChangedByAddingAndRemovingAnEntry)
{
    for (unsigned seed = 0; seed < 500; ++seed)
    {
        const Dictionary drawn = Draw(seed).dictionary(3);
        try
        {
            TextEditor editor(dictionaryText(drawn), "drawn", "");
            editor.add("added", "(1 2)");
            editor.set("added", "3");
            EXPECT_EQ(editor.dictionary().number("added"), 3);
            const bool patterned = Dictionary(drawn).has("added"); // by a pattern: then it cannot vanish
            if (patterned) { continue; }
            editor.remove("added");
            expectSame(drawn, editor.dictionary());
        }
        catch (const Error& error)
        {
            ASSERT_TRUE(isHonest(error)) << "seed " << seed << ": " << error.what();
        }
    }
}

} // namespace
} // namespace isph
