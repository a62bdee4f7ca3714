// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/key.hpp"

#include <cmath>

#include "base/text.hpp"

namespace interphase {

Range any_number()
{
    return {"any", [](double value) { return std::isfinite(value); }};
}

Range above(double limit)
{
    return {"above " + text(limit), [limit](double value) { return value > limit; }};
}

Range at_least(double limit)
{
    return {"at least " + text(limit), [limit](double value) { return value >= limit; }};
}

Range between(double low, double high)
{
    return {"between " + text(low) + " and " + text(high),
            [low, high](double value) { return value > low && value < high; }};
}

Range from_to(double low, double high)
{
    return {text(low) + " to " + text(high), [low, high](double value) { return value >= low && value <= high; }};
}

}  // namespace interphase
