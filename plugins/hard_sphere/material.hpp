// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace interphase::hard_sphere {

/// What a law's properties are between all pairs of particle types; types count from 0.
class Materials {
public:
    Materials() = default;
    Materials(int types, std::size_t properties)
        : types_(types), properties_(properties), numbers_(static_cast<std::size_t>(types) * types * properties)
    {}

    int types() const { return types_; }

    /// Names the pair.
    int between(int a, int b) const { return a * types_ + b; }

    double& number(int pair, std::size_t property)
    {
        return numbers_[static_cast<std::size_t>(pair) * properties_ + property];
    }

    const double* numbers() const { return numbers_.data(); }  ///< [pairs x properties]

private:
    int types_ = 0;
    std::size_t properties_ = 0;
    std::vector<double> numbers_;
};

}  // namespace interphase::hard_sphere
