// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/vector.hpp"
#include "walls/place.hpp"

namespace interphase::hard_sphere {

using walls::Place;

/// What the solver changes of a sphere, one cache line. A body that nothing moves has 0 in both inverses.
struct alignas(64) Body {
    double velocity[3] = {0, 0, 0};  ///< [m/s]
    double inverse_mass = 0;         ///< [1/kg]
    double spin[3] = {0, 0, 0};      ///< angular velocity [rad/s]
    double inverse_inertia = 0;      ///< 1/I, I = m d^2/10 [1/(kg m2)]
};

/// How a sphere moves within the step if it meets nothing, one cache line.
struct alignas(64) Path {
    Place place;                     ///< at the start
    double velocity[3] = {0, 0, 0};  ///< forces included [m/s]
    double unused = 0;
};

/// Change of velocity by forces other than contacts in this step [m/s]; Path and Body have it.
struct alignas(16) Push {
    float change[3] = {0, 0, 0};
    float unused = 0;
};

/// Paths in single precision, for looks at many spheres at once. Room for a few more behind the last.
struct Coarse {
    static constexpr std::size_t behind = 16;

    std::vector<float> centre[3];  ///< from `middle` [m]
    std::vector<float> radius;     ///< [m]
    std::vector<float> velocity[3];
    double middle[3] = {0, 0, 0};
    double rounding = 0;  ///< of differences between centres, at most [m]

    /// `low`, `high`: what holds all centres, by axis [m].
    void start(const std::array<double, 3>& low, const std::array<double, 3>& high);
    void resize(std::size_t n)
    {
        for (auto* array : {&centre[0], &centre[1], &centre[2], &radius, &velocity[0], &velocity[1], &velocity[2]})
            array->resize(n + behind, 0.0f);
    }
};

/// Who a body is.
struct Label {
    int id = 0;          ///< the same on every rank
    short type = 0;      ///< of material, from 0
    bool ghost = false;  ///< another rank owns it
    bool fixed = false;  ///< nothing moves it
    int remembered = 0;  ///< the first of its entries in ImpulseMemory
};

/// A pair across two ranks is resolved by the one that owns the lower id; each of them asks.
inline bool resolves(int id_a, bool ghost_a, int id_b, bool ghost_b)
{
    return ghost_a == ghost_b ? !ghost_a : ghost_a != (id_a < id_b);
}

/// The spheres of one rank, ghosts included. All arrays have one more, of resting walls; `body` and `label` may have
/// those of moving walls behind it.
struct Bodies {
    std::vector<Body> body;
    std::vector<Path> path;
    std::vector<Label> label;
    std::vector<Push> push;
    Coarse coarse;  ///< without walls

    /// From the paths [first, last).
    void write_coarse(std::size_t first, std::size_t last);

    std::size_t size() const { return path.empty() ? 0 : path.size() - 1; }
    /// One that nothing moves, behind all others, with the velocity of a wall [m/s]. Returns which it is.
    int add_wall(const Vector& velocity)
    {
        body.emplace_back();
        set(body.back().velocity, velocity);
        label.emplace_back();
        label.back().fixed = true;
        return static_cast<int>(body.size()) - 1;
    }
    void resize(std::size_t n)
    {
        body.resize(n + 1);
        path.resize(n + 1);
        label.resize(n + 1);
        push.resize(n + 1);
        coarse.resize(n);
        body[n] = {};
        path[n] = {};
        label[n] = {};
        label[n].fixed = true;
        push[n] = {};
    }
};

}  // namespace interphase::hard_sphere
