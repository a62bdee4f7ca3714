// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <streambuf>
#include <string>

#include "base/engine_warnings.hpp"

namespace interphase {

/// What OpenFOAM prints goes on to its log, and its warnings are heard. A warning is a mark and, on lines of their own,
/// function, file, what was read, and the words, which have no mark of their end: taken are the first line of them and
/// those that are indented as it is.
class ListeningOutput : public std::streambuf {
public:
    /// `log` may be null: nothing is written then.
    ListeningOutput(std::streambuf* log, EngineWarnings& warnings) : log_(log), warnings_(warnings) {}

    /// What was printed so far is heard.
    void finish_warning();

protected:
    int overflow(int c) override;
    std::streamsize xsputn(const char* text, std::streamsize size) override;
    int sync() override;

private:
    void hear(const char* text, std::streamsize size);
    void hear_line(std::string line);

    std::streambuf* log_;
    EngineWarnings& warnings_;
    std::string line_;    ///< begun
    bool warns_ = false;  ///< a warning has begun
    std::string words_;   ///< of it
    std::string read_;    ///< what OpenFOAM was reading
};

}  // namespace interphase
