// SPDX-License-Identifier: GPL-3.0-or-later
//
// What C++ tests measure is expected to lie within its limit, and recorded as tests/program/measured.py records it.
#include "support/measured.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "support/scratch_folder.hpp"

namespace {

using namespace interphase::test;

TEST(Measured, IsRecordedWithTheLimitItIsExpectedBy)
{
    const std::filesystem::path folder = new_folder();
    setenv("INTERPHASE_MEASURED", folder.c_str(), 1);
    setenv("INTERPHASE_TEST", "some/what_test", 1);
    expect_within({"drop, \"hot\"", "Pa", "Ergun"}, 0.1, 0.3, 0.25);
    expect_below({"error", "", "exact"}, 1e-300, 2);
    EXPECT_NONFATAL_FAILURE(expect_above({"order", "", "first"}, 0.5, 0.9), "order");
    EXPECT_NONFATAL_FAILURE(expect_within({"speed", "m/s", "law"}, NAN, 1, 0.5), "speed");
    unsetenv("INTERPHASE_MEASURED");
    expect_below({"not asked for", "", ""}, 1, 2);

    std::ifstream file(folder / "some.what_test.csv");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(text,
              "\"drop, \"\"hot\"\"\",0.1,,\"Pa\",0.3,\"Ergun\",+-0.25\n"
              "\"error\",1e-300,,\"\",,\"exact\",<2\n"
              "\"order\",0.5,,\"\",,\"first\",>0.9\n"
              "\"speed\",nan,,\"m/s\",1,\"law\",+-0.5\n");
    std::filesystem::remove_all(folder);
}

}  // namespace
