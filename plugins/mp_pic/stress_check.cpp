// SPDX-License-Identifier: GPL-3.0-or-later
#include "mp_pic/stress_check.hpp"

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstddef>

#include "base/text.hpp"

namespace interphase::mp_pic {

namespace {

constexpr int parts = 10000;
constexpr double round_off = 1e-12;  // of a formula of some dozens of operations, relative

std::string first_wrong(const StressFunction& stress, const std::vector<double>& solid_fractions)
{
    std::vector<double> found;
    for (const double phi : solid_fractions)
        found.push_back(stress(phi));
    const auto told = [&](std::size_t k) {
        return text(found[k]) + " Pa at a solid fraction of " + text(solid_fractions[k]);
    };
    for (std::size_t k = 0; k < found.size(); ++k)
        if (!(std::isfinite(found[k]) && found[k] >= 0))
            return "is " + told(k) + "; it must be a finite number, not below 0, from 0 to 1";
    for (std::size_t k = 1; k < found.size(); ++k) {
        if (found[k] >= found[k - 1] * (1 - round_off)) continue;
        std::size_t end = k;
        while (end + 1 < found.size() && found[end + 1] < found[end])
            ++end;
        return "falls from " + told(k - 1) + " to " + told(end) + "; it must not, or parcels would draw together";
    }
    return "";
}

}  // namespace

std::vector<double> looked_at(double close_packing)
{
    std::vector<double> all;
    for (int k = 0; k <= parts; ++k)
        all.push_back(static_cast<double>(k) / parts);
    if (!std::binary_search(all.begin(), all.end(), close_packing))
        all.insert(std::upper_bound(all.begin(), all.end(), close_packing), close_packing);
    return all;
}

std::string complaint_of(const StressFunction& stress, const std::vector<double>& solid_fractions)
{
    std::fenv_t traps;  // a division by 0 is to be told in words
    std::feholdexcept(&traps);
    const std::string wrong = first_wrong(stress, solid_fractions);
    std::fesetenv(&traps);
    return wrong;
}

}  // namespace interphase::mp_pic
