// SPDX-License-Identifier: GPL-3.0-or-later
//
// Means and variances of fields that are known functions of time.
#include "statistics/mean_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <stdexcept>

namespace {

using namespace interphase;

const MeshView& cells()
{
    static MeshView mesh;
    mesh.volume = {1e-6, 1e-6, 2e-6};
    return mesh;
}

const Scalars& values(const std::vector<CellField>& fields, const std::string& name)
{
    for (const CellField& field : fields)
        if (field.name == name) return field.values;
    throw std::runtime_error("no field " + name);
}

/// Solids of a share of cell `c` at a velocity.
CellSolids solids(std::size_t c, double fraction, const Vector& velocity)
{
    CellSolids of_cell{fraction * cells().volume[c], {}};
    set(of_cell.flow, of_cell.volume * velocity);
    return of_cell;
}

/// `samples` evenly over three periods: what is a sine then has a mean of 0 and a mean square of 1/2, exactly.
template <class Add>
void over_whole_periods(int samples, const Add& add)
{
    for (int n = 0; n < samples; ++n)
        add(0.05 * n, std::sin(3 * 2 * M_PI * n / samples), std::cos(3 * 2 * M_PI * n / samples));
}

constexpr int samples = 60;
constexpr double round_off = 1e-14;  // some samples times the last bit of numbers of one

TEST(MeanFields, OfSines)
{
    MeanFields means(cells());
    over_whole_periods(samples, [&](double time, double sine, double cosine) {
        const Scalars voidage{0.7 + 0.2 * sine, 1, 0.4};
        const Scalars gas{2 + 3 * sine, cosine, -1 + 0.5 * cosine, 0, 0, 1, 7, 8, 9};
        // in cell 0 the solids are more where they rise: <eps v>/<eps> is not <v>
        means.add(time, voidage, gas,
                  {solids(0, 0.3 - 0.2 * sine, {1, 2 * cosine, -4 * sine}), solids(1, 0, {0, 0, 0}),
                   solids(2, 0.6, {-1, 5 * sine, 0})});
    });
    const std::vector<CellField> fields = means.fields();
    const auto expect = [&](const std::string& name, const Scalars& expected) {
        const Scalars& found = values(fields, name);
        ASSERT_EQ(found.size(), expected.size()) << name;
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_NEAR(found[i], expected[i], round_off * samples) << name << " " << i;
    };
    expect("meanVoidage", {0.7, 1, 0.4});
    expect("varianceVoidage", {0.2 * 0.2 / 2, 0, 0});
    expect("meanU", {2, 0, -1, 0, 0, 1, 7, 8, 9});
    expect("varianceU", {4.5, 0.5, 0.125, 0, 0, 0, 0, 0, 0});
    // <(0.3 - 0.2 s) (-4 s)> = 0.4; about the mean m: <(0.3 - 0.2 s) 16 s^2>/0.3 - m^2 = 8 - m^2, as <s^3> = 0
    constexpr double rise = 0.4 / 0.3;
    expect("meanSolidsU", {1, 0, rise, 0, 0, 0, -1, 0, 0});
    expect("varianceSolidsU", {0, 2, 8 - rise * rise, 0, 0, 0, 0, 12.5, 0});
    EXPECT_EQ(means.samples(), samples);
}

TEST(MeanFields, DoNotLoseASmallVarianceBesideALargeMean)
{
    MeanFields means(cells());
    constexpr double speed = 1e6, amplitude = 1e-3;  // a sum of squares would leave 1e12 * 1e-16 = 1e-4
    over_whole_periods(6000, [&](double time, double sine, double) {
        const double u = speed + amplitude * sine;
        means.add(time, {1, 1, 1}, {u, u, u, 0, 0, 0, 0, 0, 0},
                  {solids(0, 0.1, {u, 0, 0}), solids(1, 0, {0, 0, 0}), solids(2, 0, {0, 0, 0})});
    });
    // what rounding of the values themselves leaves: 1e-10 of a speed of 1e6, beside 1e-3
    constexpr double of_values = 1e-6;
    for (const char* name : {"varianceU", "varianceSolidsU"})
        EXPECT_NEAR(values(means.fields(), name)[0] / (amplitude * amplitude / 2), 1, of_values) << name;
}

TEST(MeanFields, GoOnWhereTheyWereKept)
{
    MeanFields straight(cells());
    std::optional<MeanFields> stopped(cells());
    over_whole_periods(samples, [&](double time, double sine, double cosine) {
        for (MeanFields* means : {&straight, &*stopped})
            means->add(time, {sine, cosine, 1}, {1, 2 * sine, 3, 4, 5, 6 * cosine, 7, 8, 9},
                       {solids(0, 0.2 + 0.1 * sine, {sine, 1, cosine}), solids(1, 0.1, {0, sine, 0}),
                        solids(2, 0.3, {1, 1, 1})});
        if (straight.samples() != 17) return;
        Archive saved;
        stopped->keep(saved);
        Archive loading = saved.to_load();
        stopped.emplace(cells());
        stopped->keep(loading);
    });
    EXPECT_EQ(stopped->samples(), samples);
    for (std::size_t field = 0; field < 6; ++field)
        EXPECT_EQ(stopped->fields()[field].values, straight.fields()[field].values);
}

}  // namespace
