// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/pair_search.hpp"

#include <algorithm>
#include <cstring>

#include "hard_sphere/processor.hpp"

namespace interphase::hard_sphere {

namespace {

// Two ranges side by side, each of which holds hardly more spheres than this even in a dense bed: so the processor need
// not guess how often to look.
constexpr int half = 8, width = 2 * half;
static_assert(Coarse::behind >= half);
using Halves = float __attribute__((vector_size(4 * half)));
using Floats = float __attribute__((vector_size(4 * width)));
using HalfInts = int __attribute__((vector_size(4 * half)));
using Ints = int __attribute__((vector_size(4 * width)));
using Bytes = signed char __attribute__((vector_size(width)));

INTERPHASE_INLINE Floats load(const float* a, const float* b)
{
    Halves low, high;
    std::memcpy(&low, a, sizeof low);
    std::memcpy(&high, b, sizeof high);
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}

INTERPHASE_INLINE Ints in_halves(int a, int b)
{
    const HalfInts low = HalfInts{} + a, high = HalfInts{} + b;
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}

/// All bits set where the value is below zero, by its sign. Comparisons of vectors the compiler (gcc 12) would take
/// apart, number by number.
INTERPHASE_INLINE Ints below_zero(const Floats& values) { return (Ints)values >> 31; }

INTERPHASE_INLINE Floats choose(const Ints& where, const Floats& yes, const Floats& no)
{
    return (Floats)(((Ints)yes & where) | ((Ints)no & ~where));
}

INTERPHASE_INLINE Floats smaller(const Floats& a, const Floats& b) { return choose(below_zero(a - b), a, b); }

}  // namespace

void PairSearch::find(const Bodies& bodies, const CellGrid& grid, double step, double margin, double touching)
{
    look_through(bodies.coarse, grid, step, margin, touching);
    touches_.assign(bodies.size() + 1, 0);
    write_pairs();
}

INTERPHASE_CLONES
void PairSearch::look_through(const Coarse& spheres, const CellGrid& grid, double step, double margin, double touching)
{
    const float *x = spheres.centre[0].data(), *y = spheres.centre[1].data(), *z = spheres.centre[2].data();
    const float *u = spheres.velocity[0].data(), *v = spheres.velocity[1].data(), *w = spheres.velocity[2].data();
    const float* radius = spheres.radius.data();
    const float beside = static_cast<float>(margin + spheres.rounding);
    const float less = static_cast<float>(margin - touching), dt = static_cast<float>(step);
    const Ints lane{0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
    const Floats one = Floats{} + 1;
    if (rows_.empty()) rows_.resize(1024);
    Row *row = rows_.data(), *full = row + rows_.size();

    grid.candidates([&](int i, CellGrid::Range a, CellGrid::Range b) __attribute__((always_inline)) {
        const float keep = radius[i] + beside;
        for (; a.first < a.last || b.first < b.last; a.first += half, b.first += half) {
            const int j = std::min(a.first, a.last), k = std::min(b.first, b.last);
            const Floats dx = load(x + j, x + k) - x[i], dy = load(y + j, y + k) - y[i], dz = load(z + j, z + k) - z[i];
            const Floats du = load(u + j, u + k) - u[i], dv = load(v + j, v + k) - v[i], dw = load(w + j, w + k) - w[i];
            const Floats within = load(radius + j, radius + k) + keep, hits = within - less;
            const Floats squared = dx * dx + dy * dy + dz * dz;
            const Floats closing = dx * du + dy * dv + dz * dw;
            const Floats speed2 = du * du + dv * dv + dw * dw;
            // The squared distance is squared + (2 closing + speed2 t) t: smallest at either end of the step, or in
            // between by closing^2/speed2 below the start. Multiplied by speed2 that needs no division.
            const Floats closing_at_end = closing + dt * speed2;
            const Floats at_end = squared + dt * (closing + closing_at_end);
            // where they are at rest to each other this is a zero, whose sign does not count
            const Ints between = below_zero(closing * closing_at_end + 0.0f);
            const Floats scale = choose(between, speed2, one);
            const Floats nearest = choose(between, squared * speed2 - closing * closing, smaller(squared, at_end));
            const Ints valid = (lane - in_halves(a.last - j, b.last - k)) >> 31;
            const Ints near = below_zero(nearest - within * within * scale) & valid & 1,
                       touch = below_zero(nearest - hits * hits * scale) & valid & 2;
            const Bytes found = __builtin_convertvector(near | touch, Bytes);
            row->i = i;
            row->first[0] = j;
            row->first[1] = k;
            std::memcpy(row->found, &found, sizeof found);
            // the next one overwrites a row without pairs: no branch that would depend on where spheres are
            row += (row->found[0] | row->found[1]) != 0;
            if (row == full) {
                const std::size_t count = rows_.size();
                rows_.resize(2 * count);
                row = rows_.data() + count;
                full = rows_.data() + rows_.size();
            }
        }
    });
    row_count_ = static_cast<std::size_t>(row - rows_.data());
}

void PairSearch::look_again(const Bodies& bodies, double step, double margin, double touching)
{
    touches_.assign(bodies.size() + 1, 0);
    Pair* kept = pairs_.data();
    for (const Pair& pair : *this) {
        const auto i = static_cast<std::size_t>(pair.i), j = static_cast<std::size_t>(pair.j);
        const walls::Place &a = bodies.path[i].place, &b = bodies.path[j].place;
        const Vector apart = to_vector(b.centre) - to_vector(a.centre);
        const Vector meeting = to_vector(bodies.path[j].velocity) - to_vector(bodies.path[i].velocity);
        const double closing = apart.dot(meeting), speed2 = meeting.squaredNorm();
        const double then = speed2 > 0 ? std::clamp(-closing / speed2, 0.0, step) : 0;  // when they are nearest
        const double gap = (apart + then * meeting).norm() - a.radius - b.radius;
        if (gap > margin) continue;
        const unsigned touch = gap < touching ? 1 : 0;
        *kept++ = {pair.i, pair.j, touch};
        count_touch(touches_[i], touch);
        count_touch(touches_[j], touch);
    }
    used_ = static_cast<std::size_t>(kept - pairs_.data());
}

void PairSearch::write_pairs()
{
    used_ = 0;
    for (std::size_t k = 0; k < row_count_; ++k) {
        const Row& row = rows_[k];
        if (used_ + width > pairs_.size()) pairs_.resize(2 * used_ + 1024);
        Pair* pair = &pairs_[used_];
        for (int range = 0; range < 2; ++range)
            for (std::uint64_t left = row.found[range]; left != 0;) {
                const int bit = __builtin_ctzll(left);
                const auto found = static_cast<unsigned>(left >> bit & 3);
                left &= ~(std::uint64_t{3} << bit);
                const int j = row.first[range] + bit / 8;
                *pair++ = {row.i, j, found >> 1};
                count_touch(touches_[static_cast<std::size_t>(row.i)], found >> 1);
                count_touch(touches_[static_cast<std::size_t>(j)], found >> 1);
            }
        used_ = static_cast<std::size_t>(pair - pairs_.data());
    }
}

}  // namespace interphase::hard_sphere
