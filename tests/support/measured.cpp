// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/measured.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <fstream>

namespace interphase::test {
namespace {

/// As few digits as give the same number back.
std::string number(double value)
{
    std::array<char, 32> text;
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string quoted(const std::string& text)
{
    std::string all = "\"";
    for (const char c : text)
        all += c == '"' ? "\"\"" : std::string(1, c);
    return all + '"';
}

/// Serial tests have no MPI.
bool on_first_rank()
{
    int running = 0, rank = 0;
    MPI_Initialized(&running);
    if (running) MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return rank == 0;
}

void record(const Quantity& quantity, double value, const std::string& reference, const std::string& limit)
{
    const char *folder = std::getenv("INTERPHASE_MEASURED"), *test = std::getenv("INTERPHASE_TEST");
    if (!folder || !test || !on_first_rank()) return;
    std::string name = test;
    std::replace(name.begin(), name.end(), '/', '.');
    std::ofstream file(std::string(folder) + '/' + name + ".csv", std::ios::app);
    file << quoted(quantity.name) << ',' << number(value) << ",," << quoted(quantity.unit) << ',' << reference << ','
         << quoted(quantity.source) << ',' << limit << '\n';
    EXPECT_TRUE(file.flush()) << "no room in " << folder;
}

}  // namespace

void expect_within(const Quantity& quantity, double value, double reference, double limit)
{
    record(quantity, value, number(reference), "+-" + number(limit));
    EXPECT_NEAR(value, reference, limit) << quantity.name;
}

void expect_below(const Quantity& quantity, double value, double limit)
{
    record(quantity, value, "", '<' + number(limit));
    EXPECT_LT(value, limit) << quantity.name;
}

void expect_above(const Quantity& quantity, double value, double limit)
{
    record(quantity, value, "", '>' + number(limit));
    EXPECT_GT(value, limit) << quantity.name;
}

}  // namespace interphase::test
