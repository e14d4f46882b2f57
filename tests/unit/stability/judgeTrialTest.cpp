#include "stability/judgeTrial.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace isph
{

namespace
{

/// Waves that are carried, so that the imaginary limit of RK3 is reached at dt = 1.
Prediction ofCarriedWaves()
{
    const TimeScheme* scheme = timeSchemes()[Word{"RK3", {}}];
    Prediction prediction{.scheme = scheme, .limit = 1, .modes = {}};
    for (const double part : {-1.0, -0.4, 0.0, 0.7, 1.0})
    {
        prediction.modes.push_back({.explicitRate = {0, part * scheme->imaginaryLimit}});
    }
    return prediction;
}

/// Noise that grows by a factor every step, taken every ten.
NoiseHistory growing(double factor, int count, double dt = 0.1)
{
    NoiseHistory history{.times = {}, .amplitudes = {}, .steps = {}, .dt = dt};
    for (int i = 0; i <= count; ++i)
    {
        history.times.push_back(10 * i * dt);
        history.steps.push_back(10 * i);
        history.amplitudes.push_back(1e-6 * std::pow(factor, 10 * i));
    }
    return history;
}

} // namespace

TEST(JudgeTrial, ExpectsStabilityBelowTheLimitAndGrowthAbove)
{
    const Prediction prediction = ofCarriedWaves();
    EXPECT_EQ(expectation(prediction, 0.5), Verdict::stable);
    EXPECT_EQ(expectation(prediction, 0.98), Verdict::stable);
    EXPECT_EQ(expectation(prediction, 1.03), Verdict::unstable);
    EXPECT_EQ(expectation(prediction, 2), Verdict::unstable);
    EXPECT_NEAR(*predictedGrowth(prediction, 1.03), std::log(1.0254), 1e-4);
}

TEST(JudgeTrial, AWrongLimitIsContradicted)
{
    // The suite would print 1.1 where waves bear 1: what is expected to be stable grows.
    Prediction optimistic = ofCarriedWaves();
    optimistic.limit = 1.1;
    const Verdict expected = expectation(optimistic, 1.05);
    EXPECT_EQ(expected, Verdict::stable);
    const Outcome trial{.dt = 1.05, .growth = *predictedGrowth(optimistic, 1.05), .steps = 400};
    EXPECT_EQ(observation(trial), Verdict::unstable);
    EXPECT_FALSE(agree(expected, observation(trial)));

    // And modes that ought to grow, but do not.
    const Prediction right = ofCarriedWaves();
    EXPECT_FALSE(agree(expectation(right, 1.03), observation({.dt = 1.03, .growth = 0, .steps = 400})));
}

TEST(JudgeTrial, SaysNothingBeyondALimitThatIsOnlySufficient)
{
    Prediction prediction = ofCarriedWaves();
    prediction.modes.clear();
    prediction.sharpness = std::numeric_limits<double>::infinity();
    EXPECT_EQ(expectation(prediction, 0.98), Verdict::stable);
    EXPECT_EQ(expectation(prediction, 1.5), Verdict::either);
    EXPECT_TRUE(agree(Verdict::either, Verdict::stable));
    EXPECT_TRUE(agree(Verdict::either, Verdict::unstable));
}

TEST(JudgeTrial, WaitsForTheSharpnessOfALimit)
{
    Prediction prediction = ofCarriedWaves();
    prediction.sharpness = 1.2;
    EXPECT_EQ(expectation(prediction, 1.1), Verdict::either);
    EXPECT_EQ(expectation(prediction, 1.2), Verdict::unstable);
}

TEST(JudgeTrial, ExpectsModesThatGrowInExactTimeToGrowWithAnyStep)
{
    Prediction prediction = ofCarriedWaves();
    prediction.modes.push_back({.explicitRate = {0.1, 0.2}});
    EXPECT_EQ(expectation(prediction, 0.5), Verdict::unstable);
    prediction.doubt = 100;
    EXPECT_EQ(expectation(prediction, 0.5), Verdict::either);
}

TEST(JudgeTrial, GrowthThatStepsDampIsNotExpected)
{
    // A mode that grows slowly in exact time, but turns so fast that RK3 damps it.
    Prediction prediction = ofCarriedWaves();
    prediction.modes.push_back({.explicitRate = {0.01, 1.2}});
    EXPECT_GT(exactGrowth(prediction.modes), growthThreshold);
    EXPECT_EQ(expectation(prediction, 0.9), Verdict::stable);
}

TEST(JudgeTrial, ExpectsTheGrowthOfTheProjectionUnlessATermMayDampIt)
{
    Prediction prediction = ofCarriedWaves();
    prediction.growthAtRest = 0.2;
    EXPECT_EQ(expectation(prediction, 0.01), Verdict::unstable);
    prediction.mayDamp = true;
    EXPECT_EQ(expectation(prediction, 0.01), Verdict::either);
    prediction.growthAtRest = -1;
    EXPECT_EQ(expectation(prediction, 0.01), Verdict::stable);
}

TEST(JudgeTrial, ReadsTheGrowthOfAStep)
{
    EXPECT_NEAR(growthOf(growing(1.02, 30)), std::log(1.02), 1e-12);
    EXPECT_EQ(growthOf(growing(0.9, 30)), -1) << "round-off that is left of it";

    // What dies out at first does not count.
    NoiseHistory late = growing(1.02, 30);
    for (std::size_t i = 0; i < 15; ++i) { late.amplitudes[i] = 1; }
    EXPECT_NEAR(growthOf(late), std::log(1.02), 1e-12);
    EXPECT_EQ(growthOf(NoiseHistory{.times = {0}, .amplitudes = {1}, .steps = {0}}), 0);
}

TEST(JudgeTrial, ANumberThatIsNoneIsUnstable)
{
    EXPECT_EQ(observation({.growth = -1, .finite = false}), Verdict::unstable);
    EXPECT_EQ(observation({.growth = NAN}), Verdict::unstable);
    EXPECT_EQ(observation({.growth = 0.5 * growthThreshold}), Verdict::stable);
}

TEST(JudgeTrial, TakesOffWhatAFlowDoesToNoiseByItself)
{
    // The same growth in time with steps half as long is the flow's.
    const NoiseHistory reference = growing(1.01, 60, 0.05);
    EXPECT_LE(growthBeyond(reference, growing(1.0201, 30, 0.1)), growthThreshold);
    EXPECT_GT(growthBeyond(reference, growing(1.06, 30, 0.1)), growthThreshold);
    EXPECT_NEAR(growthBeyond(growing(0.99, 60, 0.05), growing(1.06, 30, 0.1)), std::log(1.06), 1e-12);
}

} // namespace isph
