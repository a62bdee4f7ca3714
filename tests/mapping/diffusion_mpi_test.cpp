// SPDX-License-Identifier: GPL-3.0-or-later
//
// Diffusion along the faces: fewer sweeps do what many steps would, contents stay whole and positive, and no pattern of
// the grid survives.
#include "mapping/diffusion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/mapped_spheres.hpp"
#include "support/mesh_zoo.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A mesh cut to ranks at random, its graph, and a diffusion on it.
class Spread {
public:
    Spread(const WholeMesh& mesh, const std::function<double(double)>& half_variance)
        : partition(Partition::at_random(mesh.cells, world().size())),
          graph(world(), mesh.part(partition.rank_of, partition.number_on, world().rank())),
          diffusion(graph, world(), half_variance)
    {
        for (std::size_t c = 0; c < mesh.cells; ++c)
            if (partition.rank_of[c] == world().rank()) cells.push_back(c);
    }

    Scalars own(const Scalars& all) const
    {
        Scalars values;
        for (const std::size_t c : cells)
            values.push_back(all[c]);
        return values;
    }
    Scalars whole(const Scalars& own) const
    {
        Scalars all(partition.rank_of.size(), 0.0);
        for (std::size_t i = 0; i < cells.size(); ++i)
            all[cells[i]] = own[i];
        world().sum(all);
        return all;
    }
    Scalars spread(const Scalars& all) const
    {
        Scalars contents = own(all);
        diffusion.spread(contents);
        return whole(contents);
    }
    Scalars smooth(const Scalars& all) const
    {
        Scalars values = own(all);
        diffusion.smooth(values);
        return whole(values);
    }

private:
    Partition partition;
    std::vector<std::size_t> cells;  ///< own, by their numbers in the whole
    CellGraph graph;

public:
    Diffusion diffusion;
};

/// The same step by step from the definition, for one half-variance everywhere: `steps` and the values of the whole
/// mesh.
struct StepByStep {
    int steps = 0;
    Scalars smooth(const WholeMesh& mesh, double half_variance, Scalars values)
    {
        const MeshView view = whole_view(mesh);
        struct Pair {
            std::size_t a, b;
            double flow;  ///< per difference of densities [m3]
        };
        std::vector<Pair> pairs;
        for (const MeshView::Face& face : view.faces) {
            std::size_t a = at(face.owner), b = a;
            Vector between;
            if (face.neighbour >= 0) {
                b = at(face.neighbour);
                between = view.centre[b] - view.centre[a];
            } else if (face.partner >= 0) {
                const MeshView::Face& twin = view.faces[at(face.partner)];
                b = at(twin.owner);
                if (face.partner < static_cast<int>(&face - view.faces.data())) continue;  // once for both
                between = face.centre - view.centre[a] + view.centre[b] - twin.centre;
            } else
                continue;
            pairs.push_back({a, b, half_variance * std::abs(face.area.dot(between)) / between.squaredNorm()});
        }
        Scalars given(view.size(), 0.0);
        for (const Pair& pair : pairs) {
            given[pair.a] += pair.flow / view.volume[pair.a];
            given[pair.b] += pair.flow / view.volume[pair.b];
        }
        steps = static_cast<int>(std::ceil(1.5 * *std::max_element(given.begin(), given.end())));
        for (int n = 0; n < steps; ++n) {
            Scalars change(view.size(), 0.0);
            for (const Pair& pair : pairs) {
                const double flow = pair.flow / steps * (values[pair.b] - values[pair.a]);
                change[pair.a] += flow / view.volume[pair.a];
                change[pair.b] -= flow / view.volume[pair.b];
            }
            for (std::size_t c = 0; c < values.size(); ++c)
                values[c] += change[c];
        }
        return values;
    }
};

Scalars noisy(std::size_t count)
{
    Scalars values;
    for (std::size_t c = 0; c < count; ++c)
        values.push_back(noise(c));
    return values;
}

TEST(Diffusion, DoesInFewerSweepsWhatManyStepsDo)
{
    for (const NamedMesh& each : mesh_zoo())
        for (const double half_variance : {0.0137, 0.3137, 3.137, 103.137}) {
            const Scalars start = noisy(each.mesh.cells);
            StepByStep slow;
            const Scalars expected = slow.smooth(each.mesh, half_variance, start);
            const Spread fast(each.mesh, [=](double) { return half_variance; });
            const Scalars values = fast.smooth(start);
            // round-off of some thousand steps, at random, and what the polynomials leave out, 1e-15 each
            for (std::size_t c = 0; c < values.size(); ++c)
                EXPECT_NEAR(values[c], expected[c], 1e-12) << each.name << ", " << slow.steps << " steps";
            // of those of degree above k, a part 2 exp(-k^2 / 2 s) is left: 1e-15 of it at 8.4 sqrt(s)
            EXPECT_LE(fast.diffusion.sweeps(), std::min(slow.steps, static_cast<int>(8.5 * std::sqrt(slow.steps)) + 1));
        }
}

TEST(Diffusion, OfTenThousandStepsIsAsExact)
{
    // a wave over a box of 40 cells with walls: each step takes the same part of it
    const int n = 40;
    const WholeMesh mesh = WholeMesh::of_boxes(unit_planes({n, 1, 1}));
    for (const double half_variance : {50.0, 500.0, 5000.0}) {
        const int steps = static_cast<int>(std::ceil(3 * half_variance));
        const Spread diffused(mesh, [=](double) { return half_variance; });
        for (const int waves : {1, 2, 5}) {
            const double k = M_PI * waves / n;
            Scalars wave;
            for (int c = 0; c < n; ++c)
                wave.push_back(std::cos(k * (c + 0.5)));
            const double left = std::pow(1 - half_variance / steps * (2 - 2 * std::cos(k)), steps);
            const Scalars values = diffused.smooth(wave);
            for (int c = 0; c < n; ++c)
                EXPECT_NEAR(values[at(c)], left * wave[at(c)], 1e-12) << steps << " steps, " << waves << " half waves";
        }
    }
}

TEST(Diffusion, ContentsStayWholeAndPositiveAndUniformDensityWhatItIs)
{
    for (const NamedMesh& each : mesh_zoo()) {
        const MeshView view = whole_view(each.mesh);
        for (const double half_variance : {0.01, 1.0, 30.0}) {
            const Spread diffused(each.mesh, [=](double) { return half_variance; });
            Scalars one(each.mesh.cells, 0.0);
            one[each.mesh.cells / 2] = 1;
            double sum = 0;
            for (const double content : diffused.spread(one)) {
                EXPECT_GE(content, -1e-15) << each.name;  // what the polynomials leave out
                sum += content;
            }
            EXPECT_NEAR(sum, 1.0, 1e-13) << each.name;
            const Scalars uniform = diffused.spread(view.volume);
            for (std::size_t c = 0; c < uniform.size(); ++c)
                EXPECT_NEAR(uniform[c] / view.volume[c], 1.0, 1e-13) << each.name;
        }
    }
}

TEST(Diffusion, IsSymmetricInTheProductWeightedByVolumes)
{
    for (const NamedMesh& each : mesh_zoo()) {
        const MeshView view = whole_view(each.mesh);
        const Spread diffused(each.mesh, [](double distance) { return 2 + 0.3 * distance; });
        Scalars a = noisy(each.mesh.cells), b = noisy(2 * each.mesh.cells);
        b.erase(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(each.mesh.cells));
        const Scalars smooth_a = diffused.smooth(a), smooth_b = diffused.smooth(b), spread_a = diffused.spread(a);
        double ab = 0, ba = 0, there = 0, back = 0;
        for (std::size_t c = 0; c < a.size(); ++c) {
            ab += view.volume[c] * smooth_a[c] * b[c];
            ba += view.volume[c] * a[c] * smooth_b[c];
            there += spread_a[c] * b[c];
            back += a[c] * smooth_b[c];
        }
        EXPECT_NEAR(ab, ba, 1e-12) << each.name;
        EXPECT_NEAR(there, back, 1e-12) << each.name;
    }
}

TEST(Diffusion, CalmsCellsThatFillAndEmptyInTurn)
{
    const std::array<int, 3> n{4, 4, 4};
    const WholeMesh mesh = WholeMesh::of_boxes(unit_planes(n), {true, true, true});
    Scalars checkerboard;
    for (int k = 0; k < n[2]; ++k)
        for (int j = 0; j < n[1]; ++j)
            for (int i = 0; i < n[0]; ++i)
                checkerboard.push_back((i + j + k) % 2 == 0 ? 1 : -1);
    double before = 1;
    for (const double half_variance : {0.02, 0.1, 0.2, 0.5, 1.0, 2.0}) {
        const Scalars values = Spread(mesh, [=](double) { return half_variance; }).smooth(checkerboard);
        // of six faces' part in a step, at most two thirds, twice as much is lost
        const int steps = static_cast<int>(std::ceil(1.5 * 6 * half_variance));
        const double left = std::pow(1 - 12 * half_variance / steps, steps);
        EXPECT_NEAR(values[0], left, 1e-13);
        EXPECT_LE(std::abs(left), std::pow(1.0 / 3, steps - 1));
        EXPECT_LT(std::abs(values[0]), before);
        before = std::abs(values[0]);
    }
}

TEST(Diffusion, OfNothingIsNothing)
{
    const Spread still(WholeMesh::of_boxes(unit_planes({3, 2, 2})), [](double) { return 0.0; });
    EXPECT_EQ(still.diffusion.sweeps() > 0, false);
    EXPECT_EQ(still.smooth(noisy(12)), noisy(12));
    EXPECT_EQ(still.spread(noisy(12)), noisy(12));
}

}  // namespace
