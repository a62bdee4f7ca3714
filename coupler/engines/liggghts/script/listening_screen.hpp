// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <string>

#include "base/engine_warnings.hpp"

namespace interphase {

/// LIGGGHTS's `screen`: what it writes goes on to the stream that it had before, and its warnings are heard. LIGGGHTS
/// writes them there and tells nobody else.
class ListeningScreen {
public:
    /// Takes the place of `screen`, which it closes when LIGGGHTS closes it. Lives as long as LIGGGHTS writes.
    ListeningScreen(std::FILE*& screen, EngineWarnings& warnings);
    ~ListeningScreen();
    ListeningScreen(const ListeningScreen&) = delete;
    ListeningScreen& operator=(const ListeningScreen&) = delete;

    /// All that was written so far is in the log, and heard.
    void flush();

private:
    static ssize_t write(void* self, const char* text, std::size_t size);
    static int close(void* self);
    void hear(const char* text, std::size_t size);

    std::FILE* before_;
    std::FILE* own_ = nullptr;
    EngineWarnings& warnings_;
    std::string line_;  ///< begun
};

/// The warning that a line of LIGGGHTS's is, without its mark and the place in LIGGGHTS's sources; empty for others.
std::string warning_in(const std::string& line);

}  // namespace interphase
