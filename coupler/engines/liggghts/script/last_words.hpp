// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>

namespace interphase {

/// LIGGGHTS ends the process on an error, with its words in its log only. While one of these lives, its errors are
/// UserErrors with the end of that log instead, those of one rank with the end of what it said there; an end of the
/// process by other ways shows them.
class LastWords {
public:
    static constexpr const char* log_name = "dem/log.liggghts";

    /// Makes the folder of the log, too; a UserError where there can be none, or no log in it.
    explicit LastWords(bool speaks);

    /// A stream for LIGGGHTS's `screen` on a rank that has no log: only its end is kept, to be shown if LIGGGHTS aborts
    /// there.
    static std::FILE* of_rank_without_log();

    /// Whether an error has left LIGGGHTS in the middle of something: it cannot be closed any more.
    static bool heard_error();

    ~LastWords();
    LastWords(const LastWords&) = delete;
    LastWords& operator=(const LastWords&) = delete;
};

/// While one of these lives, without a coupled run, errors of LIGGGHTS are UserErrors with its words, which go to its
/// log, too: LIGGGHTS itself may add a joke from memory that it has freed.
class NativeWords {
public:
    NativeWords();
    ~NativeWords();
    NativeWords(const NativeWords&) = delete;
    NativeWords& operator=(const NativeWords&) = delete;
};

}  // namespace interphase
