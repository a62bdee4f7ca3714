// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/count_news.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace interphase {

namespace {

/// What was counted since; of a measured extreme what it is now.
Count since(const std::vector<Count>& before, const Count& now)
{
    const auto same = [&now](const Count& other) { return std::string(other.kind->key) == now.kind->key; };
    const auto earlier = std::find_if(before.begin(), before.end(), same);
    if (earlier == before.end() || now.kind->worry == Worry::above) return now;
    Count part(*now.kind, now.number - earlier->number, now.off - earlier->off);
    part.value = now.value - earlier->value;
    return part;
}

Wholes since(const Wholes& before, const Wholes& now)
{
    return {now.particle_steps - before.particle_steps, now.cell_steps - before.cell_steps,
            now.gas_steps - before.gas_steps, now.particles};
}

}  // namespace

void CountNews::begin_with(const std::vector<Count>& counts, const Wholes& wholes)
{
    before_ = counts;
    wholes_before_ = wholes;
    for (const Count& count : counts)
        if (count.kind->worry == Worry::above && to_be_looked_at(count, wholes)) told_.insert(count.kind->key);
}

std::vector<std::string> CountNews::of(const std::vector<Count>& counts, const Wholes& wholes)
{
    std::vector<std::string> news;
    const Wholes part = since(wholes_before_, wholes);
    for (const Count& count : counts) {
        const Count here = since(before_, count);
        if (!to_be_looked_at(here, part) || !told_.insert(count.kind->key).second) continue;
        const std::optional<double> share = share_of(here, part);
        news.push_back(std::string("look at \"") + count.kind->text + "\": " + amount(here) +
                       (share ? ", " + percent(*share) : "") + ", in the last " + text(part.gas_steps) +
                       " gas steps (interphase -help counts)");
    }
    begin_with(counts, wholes);
    return news;
}

}  // namespace interphase
