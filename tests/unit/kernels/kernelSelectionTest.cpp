#include "kernels/kernelSelection.hpp"

#include "support/messageOf.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

using testing::HasSubstr;

/// Settings of a sub-dictionary `kernel` written in full or in part.
KernelSettings selected(const std::string& entries)
{
    const Schema schema("schemes", {kernelKey("10")});
    const Dictionary schemes = schema.complete(Dictionary::parse("kernel { " + entries + " }", "system/schemes"));
    return selectKernel(schemes.dictionary("kernel"));
}

TEST(SelectKernel, FillsInItsDefaults)
{
    const KernelSettings settings = selected("type gaussian;");
    EXPECT_EQ(settings.kernel->order(), 10);
    EXPECT_EQ(settings.smoothingLength, 1.5);
    EXPECT_EQ(settings.symbol, KernelSettings::Symbol::closed);
    EXPECT_EQ(settings.supportRadius, 6);
    EXPECT_FALSE(settings.renormalise);
    EXPECT_FALSE(settings.exact());
}

TEST(SelectKernel, SampledKernelsAreWiderByDefault)
{
    const KernelSettings gaussian = selected("type gaussian; order 4; symbol sampled;");
    EXPECT_EQ(gaussian.symbol, KernelSettings::Symbol::sampled);
    EXPECT_EQ(gaussian.smoothingLength, 2);
    EXPECT_EQ(gaussian.supportRadius, 5);

    const KernelSettings spline = selected("type quinticSpline;");
    EXPECT_EQ(spline.symbol, KernelSettings::Symbol::sampled) << "it has no closed symbol";
    EXPECT_EQ(spline.smoothingLength, 2);
    EXPECT_EQ(spline.supportRadius, 3);
}

TEST(SelectKernel, TakesWhatIsWritten)
{
    const KernelSettings settings =
        selected("type gaussian; order 6; smoothingLength 1.3; symbol sampled; supportRadius 4; renormalise yes;");
    EXPECT_EQ(settings.kernel->order(), 6);
    EXPECT_EQ(settings.smoothingLength, 1.3);
    EXPECT_EQ(settings.supportRadius, 4);
    EXPECT_TRUE(settings.renormalise);
}

TEST(SelectKernel, TheExactDerivativeIsNeverSampled)
{
    const KernelSettings settings = selected("type exact; symbol sampled;");
    EXPECT_TRUE(settings.exact());
    EXPECT_EQ(settings.symbol, KernelSettings::Symbol::closed);
}

TEST(SelectKernel, RefusesAnOddOrderWhereItIsWritten)
{
    EXPECT_THAT(messageOf([] { selected("type gaussian; order 5;"); }),
                AllOf(HasSubstr("system/schemes:1: kernel.order: is 5 but must be even"), HasSubstr("order 4;")));
    EXPECT_THAT(messageOf([] { selected("type gaussian; order 4.5;"); }), HasSubstr("kernel.order"));
}

TEST(SelectKernel, RefusesLengthsThatAreNone)
{
    EXPECT_THAT(messageOf([] { selected("type gaussian; smoothingLength -2;"); }), HasSubstr("kernel.smoothingLength"));
    EXPECT_THAT(messageOf([] { selected("type gaussian; smoothingLength 0;"); }), HasSubstr("kernel.smoothingLength"));
    EXPECT_THAT(messageOf([] { selected("type gaussian; supportRadius wide;"); }), HasSubstr("kernel.supportRadius"));
}

TEST(SelectKernel, NamesTheKernelsThereAre)
{
    EXPECT_THAT(messageOf([] { selected("type gausian;"); }), HasSubstr("gaussian"));
    EXPECT_THAT(kernels().names(), testing::ElementsAre("gaussian", "quinticSpline", "exact"));
}

} // namespace
} // namespace isph
