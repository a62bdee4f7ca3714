// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/problem.hpp"

namespace interphase {

/// What an earlier part of a run wrote into files that its script opens (fix print, fix ave/*, print, write_data), and
/// that LIGGGHTS would empty when the script is read once more. While a Watch lives, such a file gets another name
/// before LIGGGHTS opens a new one in its place. LIGGGHTS's log goes on where it ended.
///
/// A file that was put aside comes back to its place when this object goes, unless keep() was called: a run that is
/// refused leaves all as it was.
class EarlierFiles {
public:
    /// `goes_on`: whether the run goes on from another. A run that does not, writes over what there is.
    explicit EarlierFiles(bool goes_on) : goes_on_(goes_on) {}
    ~EarlierFiles();
    EarlierFiles(const EarlierFiles&) = delete;
    EarlierFiles& operator=(const EarlierFiles&) = delete;

    class Watch {
    public:
        explicit Watch(EarlierFiles& files);
        ~Watch();
        Watch(const Watch&) = delete;
        Watch& operator=(const Watch&) = delete;
    };

    /// The run goes on from `time` [s]: files that were put aside stay beside the new ones, under names with that time.
    /// What there is to be told of this rank's.
    std::optional<Problem> keep(double time);

    /// Before `file` is emptied; false where it cannot be put aside, with errno as the system left it.
    bool put_aside(const std::string& file);

private:
    struct Moved {
        std::string name, aside;
    };

    bool goes_on_;
    std::vector<Moved> moved_;
};

}  // namespace interphase
