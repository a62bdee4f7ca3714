// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace interphase::hard_sphere {

/// What a contact between two materials does (eqs. 10 and 11 of the paper).
struct ContactLaw {
    double restitution = 1;             ///< e_n, 0 to 1
    double tangential_restitution = 1;  ///< e_t, 0 to 1, of a sticking contact
    double friction = 0;                ///< mu >= 0
};

/// The laws between all pairs of particle types; types count from 0.
class Materials {
public:
    Materials() = default;
    explicit Materials(int types) : types_(types), laws_(static_cast<std::size_t>(types) * types) {}

    ContactLaw& between(int a, int b) { return laws_[index(a, b)]; }
    const ContactLaw& between(int a, int b) const { return laws_[index(a, b)]; }
    int types() const { return types_; }

private:
    std::size_t index(int a, int b) const { return static_cast<std::size_t>(a) * types_ + static_cast<std::size_t>(b); }

    int types_ = 0;
    std::vector<ContactLaw> laws_;
};

}  // namespace interphase::hard_sphere
