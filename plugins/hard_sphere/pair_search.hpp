// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hard_sphere/bodies.hpp"
#include "hard_sphere/cell_grid.hpp"

namespace interphase::hard_sphere {

/// Places in Bodies of two spheres.
struct Pair {
    int i;
    int j : 31;
    unsigned touch : 1;  ///< they touch within the step, or all but do
};

/// Finds the pairs that come nearer than `margin` on their straight paths within a step.
class PairSearch {
public:
    /// `bodies` in the order of `grid`, whose reach was at least `margin` [m]; velocities with the forces of this step.
    /// Nearer than `touching` [m] counts as a touch.
    void find(const Bodies& bodies, const CellGrid& grid, double step, double margin, double touching);

    const Pair* begin() const { return pairs_.data(); }
    const Pair* end() const { return pairs_.data() + used_; }

private:
    void copy(const Bodies& bodies);

    // positions relative to the middle of the spheres, single precision: the margin is wider than their rounding
    std::vector<float> x_, y_, z_, radius_, u_, v_, w_;
    float rounding_ = 0;       ///< [m]
    std::vector<Pair> pairs_;  ///< grows only
    std::size_t used_ = 0;
};

}  // namespace interphase::hard_sphere
