// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/command_queue.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "fix.h"
#include "lammps.h"
#include "modify.h"

namespace interphase {

namespace {

/// What changes forces, walls, feeds and output, and leaves the particles, the box and the steps to the run.
const std::vector<std::string>& known_commands()
{
    static const std::vector<std::string> known{
        "compute", "dump",          "dump_modify",  "fix",       "fix_modify", "group", "print",    "region",
        "thermo",  "thermo_modify", "thermo_style", "uncompute", "undump",     "unfix", "variable", "velocity"};
    return known;
}

std::vector<std::string> words_of(const std::string& line)
{
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    return words;
}

bool has_variable(const std::string& word) { return word.find('$') != std::string::npos; }

std::string place_of(const TimedCommands& commands) { return std::string(place_of_commands) + "." + commands.name; }

}  // namespace

void CommandQueue::check(const LAMMPS_NS::LAMMPS& lmp) const
{
    std::set<std::string> fixes;
    for (int n = 0; n < lmp.modify->nfix; ++n)
        fixes.insert(lmp.modify->fix[n]->id);
    for (const TimedCommands& commands : commands_)
        for (const std::string& line : commands.lines) {
            const std::vector<std::string> words = words_of(line);
            const std::string first = words.empty() ? "" : words[0];
            if (!is_among(first, known_commands()))
                throw UserError("`" + line + "` is no command for a time of the run", place_of(commands),
                                "give one of " + listed(known_commands()) + "; all else belongs into the script");
            if (words.size() < 2 || has_variable(words[1])) continue;
            if (first == "fix") fixes.insert(words[1]);
            if ((first == "unfix" || first == "fix_modify") && fixes.count(words[1]) == 0)
                throw UserError(
                    "`" + line + "`: there will be no fix `" + words[1] + "` at t = " + text(commands.time) + " s",
                    place_of(commands),
                    "name a fix of the script, or one of earlier commands: " +
                        listed(std::vector<std::string>(fixes.begin(), fixes.end())));
            if (first == "unfix") fixes.erase(words[1]);
        }
}

std::vector<TimedCommands> CommandQueue::due(double time)
{
    constexpr double round_off = 1e-8;
    std::vector<TimedCommands> due;
    for (; done_ < static_cast<long>(commands_.size()); ++done_) {
        const TimedCommands& next = commands_[static_cast<std::size_t>(done_)];
        if (next.time > time + round_off * std::max(std::abs(time), std::abs(next.time))) break;
        due.push_back(next);
    }
    return due;
}

void CommandQueue::keep(Archive& archive)
{
    if (!archive.loads() || archive.has("commands_done")) archive.keep("commands_done", done_);
}

}  // namespace interphase
