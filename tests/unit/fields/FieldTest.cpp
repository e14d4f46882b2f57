#include "fields/Field.hpp"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <type_traits>
#include <utility>

namespace isph
{
namespace
{

static_assert(!std::is_copy_constructible_v<RealField>, "a silent copy is a performance bug");
static_assert(!std::is_copy_assignable_v<RealField>);
static_assert(std::is_nothrow_move_constructible_v<RealField>);
static_assert(std::is_nothrow_move_assignable_v<SpectralField>);
static_assert(!std::is_convertible_v<RealField, SpectralField>);

template<class Value>
bool aligned(const Value* address)
{
    return reinterpret_cast<std::uintptr_t>(address) % 64 == 0;
}

TEST(Field, StartsAtZero)
{
    const RealField field(3, 17);
    EXPECT_EQ(field.components(), 3);
    EXPECT_EQ(field.size(), 17U);
    for (int c = 0; c < 3; ++c)
    {
        EXPECT_EQ(field[c].size(), 17U);
        EXPECT_TRUE(std::ranges::all_of(field[c], [](double value) { return value == 0; }));
    }
    EXPECT_EQ(RealField().components(), 0);
    EXPECT_EQ(RealField().size(), 0U);
}

TEST(Field, AlignsEveryComponent)
{
    for (const std::size_t size : {1U, 2U, 7U, 8U, 9U, 31U, 64U, 1001U})
    {
        const RealField real(3, size);
        const SpectralField modes(3, size);
        for (int c = 0; c < 3; ++c)
        {
            EXPECT_TRUE(aligned(real[c].data())) << size;
            EXPECT_TRUE(aligned(modes[c].data())) << size;
        }
        EXPECT_GE(real.stride(), size);
        EXPECT_LT(real.stride(), size + 8);
        EXPECT_EQ(real[1].data() - real[0].data(), static_cast<std::ptrdiff_t>(real.stride()));
        EXPECT_EQ(modes[2].data() - modes.data(), static_cast<std::ptrdiff_t>(2 * modes.stride()));
    }
}

TEST(Field, ComponentsDoNotOverlap)
{
    RealField field(2, 5);
    std::ranges::fill(field[0], 1.0);
    std::ranges::fill(field[1], 2.0);
    EXPECT_EQ(field[0][4], 1);
    EXPECT_EQ(field[1][0], 2);
}

TEST(Field, MovesItsValuesWithoutCopying)
{
    RealField field(2, 100);
    field[1][7] = 3;
    const double* address = field.data();
    RealField moved(std::move(field));
    EXPECT_EQ(moved.data(), address);
    EXPECT_EQ(moved[1][7], 3);
    RealField assigned(1, 2);
    assigned = std::move(moved);
    EXPECT_EQ(assigned.data(), address);
    EXPECT_EQ(assigned.components(), 2);
    EXPECT_EQ(assigned.size(), 100U);
}

TEST(Field, CopiesWhenAsked)
{
    RealField field(2, 3);
    field[1][2] = 4;
    RealField copy = copyOf(field);
    EXPECT_EQ(copy.components(), 2);
    EXPECT_EQ(copy.size(), 3U);
    EXPECT_EQ(copy.stride(), field.stride());
    EXPECT_EQ(copy[1][2], 4);
    copy[1][2] = 5;
    EXPECT_EQ(field[1][2], 4);
}

} // namespace
} // namespace isph
