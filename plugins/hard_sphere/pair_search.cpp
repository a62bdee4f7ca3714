// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/pair_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "hard_sphere/processor.hpp"

namespace interphase::hard_sphere {

namespace {

constexpr int width = 8;
using Floats = float __attribute__((vector_size(4 * width)));
using Ints = int __attribute__((vector_size(4 * width)));

INTERPHASE_INLINE Floats load(const float* values)
{
    Floats vector;
    std::memcpy(&vector, values, sizeof vector);
    return vector;
}

INTERPHASE_INLINE Floats smaller(const Floats& a, const Floats& b) { return a < b ? a : b; }
INTERPHASE_INLINE Floats larger(const Floats& a, const Floats& b) { return a > b ? a : b; }

/// A bit for each lane that is not 0.
INTERPHASE_INLINE unsigned bits(const Ints& mask)
{
    Ints set = mask & Ints{1, 2, 4, 8, 16, 32, 64, 128};
    set |= __builtin_shuffle(set, Ints{4, 5, 6, 7, 0, 1, 2, 3});
    set |= __builtin_shuffle(set, Ints{2, 3, 0, 1, 2, 3, 0, 1});
    set |= __builtin_shuffle(set, Ints{1, 0, 1, 0, 1, 0, 1, 0});
    return static_cast<unsigned>(set[0]);
}

}  // namespace

void PairSearch::copy(const Bodies& bodies)
{
    const std::size_t n = bodies.size();
    for (auto* array : {&x_, &y_, &z_, &radius_, &u_, &v_, &w_})
        array->resize(n + width, 0.0f);
    double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300};
    for (std::size_t b = 0; b < n; ++b)
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], bodies.place[b].centre[axis]);
            high[axis] = std::max(high[axis], bodies.place[b].centre[axis]);
        }
    double middle[3], extent = 0;
    for (int axis = 0; axis < 3; ++axis) {
        middle[axis] = 0.5 * (low[axis] + high[axis]);
        extent = std::max(extent, high[axis] - middle[axis]);
    }
    rounding_ = static_cast<float>(4 * extent) * std::numeric_limits<float>::epsilon();
    for (std::size_t b = 0; b < n; ++b) {
        const Place& place = bodies.place[b];
        const Body& body = bodies.body[b];
        x_[b] = static_cast<float>(place.centre[0] - middle[0]);
        y_[b] = static_cast<float>(place.centre[1] - middle[1]);
        z_[b] = static_cast<float>(place.centre[2] - middle[2]);
        radius_[b] = static_cast<float>(place.radius);
        u_[b] = static_cast<float>(body.velocity[0]);
        v_[b] = static_cast<float>(body.velocity[1]);
        w_[b] = static_cast<float>(body.velocity[2]);
    }
}

INTERPHASE_CLONES
void PairSearch::find(const Bodies& bodies, const CellGrid& grid, double step, double margin, double touching)
{
    copy(bodies);
    if (pairs_.size() < 4096) pairs_.resize(4096);
    std::size_t count = 0;
    const float *x = x_.data(), *y = y_.data(), *z = z_.data(), *radius = radius_.data();
    const float *u = u_.data(), *v = v_.data(), *w = w_.data();
    const float dt = static_cast<float>(step), beside = static_cast<float>(margin) + rounding_;
    const float less = beside - (static_cast<float>(touching) + rounding_);
    const Ints lane{0, 1, 2, 3, 4, 5, 6, 7};
    const Floats zero{}, most = zero + dt, tiny = zero + 1e-30f;
    Pair* pairs = pairs_.data();
    std::size_t room = pairs_.size();

    grid.candidates([&](int i, int first, int last) __attribute__((always_inline)) {
        const float keep = radius[i] + beside;
        for (int j = first; j < last; j += width) {
            const Floats dx = load(x + j) - x[i], dy = load(y + j) - y[i], dz = load(z + j) - z[i];
            const Floats du = load(u + j) - u[i], dv = load(v + j) - v[i], dw = load(w + j) - w[i];
            const Floats within = load(radius + j) + keep;
            const Floats squared = dx * dx + dy * dy + dz * dz;
            const Floats closing = dx * du + dy * dv + dz * dw;
            const Floats speed2 = du * du + dv * dv + dw * dw;
            const Floats time = smaller(most, larger(zero, -closing / (speed2 + tiny)));
            const Floats nearest = squared + time * (closing + closing + time * speed2);
            unsigned near = bits((nearest < within * within) & (lane + j < last));
            if (near == 0) continue;
            if (count + width > room) {
                pairs_.resize(2 * room);
                pairs = pairs_.data();
                room = pairs_.size();
            }
            const Floats hits = within - less;
            const unsigned touch = bits((nearest < hits * hits) & (lane + j < last));
            for (; near != 0; near &= near - 1) {
                const int k = __builtin_ctz(near);
                pairs[count++] = {i, j + k, touch >> k & 1};
            }
        }
    });
    used_ = count;
}

}  // namespace interphase::hard_sphere
