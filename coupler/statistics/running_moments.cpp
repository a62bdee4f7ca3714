// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/running_moments.hpp"

namespace interphase {

RunningMoments::RunningMoments(std::size_t cells, std::size_t width)
    : width_(width), weight_(cells, 0.0), mean_(cells * width, 0.0), scatter_(cells * width, 0.0)
{}

void RunningMoments::add(const Scalars& values, const Scalars& weights)
{
    for (std::size_t c = 0; c < weight_.size(); ++c) {
        if (!(weights[c] > 0)) continue;
        const double before = weight_[c];
        weight_[c] += weights[c];
        const double share = weights[c] / weight_[c];
        for (std::size_t q = c * width_; q < (c + 1) * width_; ++q) {
            const double from_mean = values[q] - mean_[q];
            mean_[q] += share * from_mean;
            scatter_[q] += before * share * from_mean * from_mean;
        }
    }
}

Scalars RunningMoments::variance() const
{
    Scalars variance(scatter_.size(), 0.0);
    for (std::size_t c = 0; c < weight_.size(); ++c)
        for (std::size_t q = c * width_; q < (c + 1) * width_; ++q)
            if (weight_[c] > 0) variance[q] = scatter_[q] / weight_[c];
    return variance;
}

void RunningMoments::keep(Archive& archive)
{
    archive.keep_cells("weight", weight_);
    archive.keep_cells("mean", mean_);
    archive.keep_cells("scatter", scatter_);
}

}  // namespace interphase
