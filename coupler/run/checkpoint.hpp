// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "base/communicator.hpp"
#include "base/problem.hpp"

namespace interphase {

/// The checkpoints of a run: folders <time> of the folder checkpoints/, each with the state of every rank and a
/// manifest, which tells time, ranks, facts of the run, and size and SHA-256 of each file and of itself.
///
/// One is written under another name, brought to the disk, and then renamed: a folder with a manifest is whole, or the
/// checksums tell. The last two stay. All members are collective.
class Checkpoints {
public:
    /// What a run that goes on has to have in common with the one that wrote it: name and value.
    using Facts = std::vector<std::pair<std::string, std::string>>;

    explicit Checkpoints(const Communicator& comm, std::filesystem::path folder = "checkpoints")
        : comm_(comm), folder_(std::move(folder))
    {}

    /// Writes the state of all ranks at `time` [s]; what is wrong, if it could not be written: the last one is still
    /// there then.
    std::optional<Problem> write(double time, const Archive& state, const Facts& facts) const;

    struct Found {
        std::string path;
        double time = 0;
        int ranks = 0;
        Facts facts;
        Archive state;  ///< to load, also where the ranks are not as many
    };
    /// The newest one that is whole. `passed_over` tells of each newer one that is not.
    std::optional<Found> newest(std::vector<std::string>& passed_over) const;

    /// Of the newest one with a manifest, on the first rank; empty where there is none, and on the others.
    std::string newest_name() const;

    /// Those of an earlier run go.
    void remove_earlier() const;

    /// Those of an earlier run are moved to a folder of their own, whose name is given back; empty where there are
    /// none.
    std::string put_earlier_aside() const;

private:
    void refuse_earlier(const std::optional<std::string>& wrong) const;

    Communicator comm_;
    std::filesystem::path folder_;
};

/// The bytes of a state, and the state of bytes; a std::runtime_error where they are none.
std::string to_bytes(const Archive& state);
Archive from_bytes(const std::string& bytes);

}  // namespace interphase
