#pragma once

#include <cstdio>
#include <gtest/gtest.h>
#include <string>

namespace isph::test
{

/// Keeps a measured figure with the test's result: `--gtest_output=xml` lists them all.
inline void record(const std::string& what, double value)
{
    char text[32];
    std::snprintf(text, sizeof(text), "%.4g", value);
    testing::Test::RecordProperty(what, text);
}

} // namespace isph::test
