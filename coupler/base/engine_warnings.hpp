// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "base/communicator.hpp"
#include "base/count.hpp"

namespace interphase {

/// With the engine's name in its words.
inline constexpr CountKind warnings_of_engine{
    "warnings_of_ENGINE",
    "warnings of ENGINE",
    Whole::nothing,
    "What LIGGGHTS or OpenFOAM warned of, which they only write into their logs. Those that differ in numbers are of "
    "one kind, and each kind was told once, in the engine's words.",
    Worry::any,
    "What a warning means, the engine's words tell.",
    "read them, above or in the engine's log"};

/// What an engine warns of, which it writes into its log only: each kind is to be told once, and all are counted.
/// Warnings that differ in their numbers are of one kind.
class EngineWarnings {
public:
    /// `engine`: its name; `log`: the file in which all of them stand.
    EngineWarnings(std::string engine, std::string log);
    EngineWarnings(const EngineWarnings&) = delete;  // counts refer to its words
    EngineWarnings& operator=(const EngineWarnings&) = delete;

    const std::string& engine() const { return engine_; }
    const std::string& log() const { return log_; }

    /// On this rank. White space at its ends and in rows counts as none.
    void hear(const std::string& words);

    /// The kinds that have come up on any rank since the last call, each as it was first heard. Collective.
    std::vector<std::string> news(const Communicator& comm);

    /// Those that have come up on this rank since the last call of news(), where not all ranks can be asked.
    const std::vector<std::string>& own_news() const { return fresh_; }

    /// Their number; kinds that were told are told again in a run that goes on.
    void keep(Archive& archive) { archive.keep_share("heard", heard_); }

    /// How often a warning was heard so far, of all ranks. Not longer than this lives. Collective.
    Count count(const Communicator& comm) const { return {kind_, comm.sum(heard_)}; }

private:
    std::string engine_, log_;
    std::string key_, text_;
    CountKind kind_ = warnings_of_engine;
    std::vector<std::string> fresh_;  ///< of kinds that are not among the told
    std::set<std::string> known_;     ///< kinds that are told, or fresh
    std::set<std::string> told_;      ///< the same on all ranks
    long heard_ = 0;
};

}  // namespace interphase
