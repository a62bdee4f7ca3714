// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/count.hpp"

#include <cstdio>

namespace interphase {

double Wholes::of(Whole whole) const
{
    switch (whole) {
        case Whole::particle_steps:
            return particle_steps;
        case Whole::cell_steps:
            return cell_steps;
        case Whole::gas_steps:
            return gas_steps;
        case Whole::particles:
            return particles;
        case Whole::nothing:
            break;
    }
    return 0;
}

std::optional<double> share_of(const Count& count, const Wholes& wholes)
{
    const double all = wholes.of(count.kind->whole);
    return all > 0 ? std::optional(static_cast<double>(count.number) / all) : std::nullopt;
}

std::optional<double> weighed_share(const Count& count, const Wholes& wholes)
{
    const double all = wholes.of(count.kind->whole);
    return all > 0 ? std::optional(count.off / all) : std::nullopt;
}

bool to_be_looked_at(const Count& count, const Wholes& wholes)
{
    switch (count.kind->worry) {
        case Worry::never:
            return false;
        case Worry::any:
            return count.value > 0;
        case Worry::above:
            return count.value > count.kind->limit;
        case Worry::share:
            break;
    }
    return weighed_share(count, wholes).value_or(0) > tolerable_share;
}

std::string verdict(const Count& count, const Wholes& wholes)
{
    if (count.value == 0) return "";
    const bool look = to_be_looked_at(count, wholes);
    const std::string words = look ? "look at it" : "ordinary";
    if (count.kind->worry != Worry::share) return words;
    const std::optional<double> share = weighed_share(count, wholes);
    if (!share) return "";
    const bool weighed = count.off != static_cast<double>(count.number);
    if (weighed) return words + ": moves a mean by up to " + percent(*share);
    return words + (look ? ": above " : ": below ") + percent(tolerable_share);
}

std::string name_of(Whole whole)
{
    switch (whole) {
        case Whole::particle_steps:
            return "of the particles, gas step by gas step";
        case Whole::cell_steps:
            return "of the gas cells, gas step by gas step";
        case Whole::gas_steps:
            return "of the gas steps";
        case Whole::particles:
            return "of the particles";
        case Whole::nothing:
            break;
    }
    return "";
}

std::string percent(double share)
{
    char text[32];
    constexpr double shown_as_a_hundred = 0.995;  // by two digits, which are 1e+02 then
    std::snprintf(text, sizeof text, share < shown_as_a_hundred ? "%.2g %%" : "%.0f %%", 100 * share);
    return text;
}

std::string with_separators(long number)
{
    std::string digits = std::to_string(number);
    const std::size_t sign = number < 0 ? 1 : 0;
    for (std::size_t at = digits.size(); at > sign + 3;) {
        at -= 3;
        digits.insert(at, ",");
    }
    return digits;
}

std::string amount(const Count& count)
{
    if (*count.kind->unit == '\0') return with_separators(count.number);
    char text[48];
    std::snprintf(text, sizeof text, "%.3g %s", count.value, count.kind->unit);
    return text;
}

}  // namespace interphase
