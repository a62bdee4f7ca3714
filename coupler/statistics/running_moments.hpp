// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/archive.hpp"
#include "base/vector.hpp"

namespace interphase {

/// Weighted mean and variance, cell by cell, of values that come one after the other and are not kept: updated as
/// D. H. D. West, Commun. ACM 22 (1979) 532, which does not lose a small variance beside a large mean.
class RunningMoments {
public:
    /// Of quantities [cells x width].
    RunningMoments(std::size_t cells, std::size_t width);

    /// `values` [cells x width], `weights` [cells]; a cell without weight is left as it is.
    void add(const Scalars& values, const Scalars& weights);

    /// sum w q / sum w [cells x width]; 0 where there was no weight.
    const Scalars& mean() const { return mean_; }

    /// sum w (q - mean)^2 / sum w [cells x width]; 0 where there was no weight.
    Scalars variance() const;

    void keep(Archive& archive);

private:
    std::size_t width_;
    Scalars weight_, mean_, scatter_;
};

}  // namespace interphase
