// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>

namespace interphase {

/// How many real particles each tracked one of a rank stands for (the statistic weight W of a parcel): one number for
/// all, or a property of each.
class ParticleWeights {
public:
    static ParticleWeights same(double of_all) { return {false, of_all, nullptr}; }
    static ParticleWeights of_each(const double* own) { return {true, 0, own}; }  ///< [n]

    /// Whether each particle has its own; on all ranks or on none.
    bool differ() const { return differ_; }

    double operator[](std::size_t i) const { return differ_ ? own_[i] : same_; }

private:
    ParticleWeights(bool differ, double of_all, const double* own) : differ_(differ), same_(of_all), own_(own) {}

    bool differ_;
    double same_;
    const double* own_;
};

/// The diameter of the real particle, 2 r W^(-1/3), of spheres one after the other: a cube root is dear, and most share
/// their weight.
class RealDiameter {
public:
    double operator()(double radius, double weight)
    {
        if (weight != weight_) {
            weight_ = weight;
            per_tracked_ = 1.0 / std::cbrt(weight);
        }
        return 2 * radius * per_tracked_;
    }

private:
    double weight_ = 1, per_tracked_ = 1;
};

}  // namespace interphase
