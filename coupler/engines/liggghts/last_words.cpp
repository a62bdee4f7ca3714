// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/last_words.hpp"

#include <mpi.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <string>
#include <thread>

namespace interphase {

namespace {

bool listening = false;
bool speaking = false;

void show()
{
    listening = speaking = false;
    std::fflush(nullptr);  // of LIGGGHTS's own stream above all
    std::ifstream log(LastWords::log_name);
    std::deque<std::string> last;
    for (std::string line; std::getline(log, line);) {
        if (line.empty()) continue;
        last.push_back(line);
        if (last.size() > 6) last.pop_front();
    }
    std::fprintf(stderr, "\ninterphase: error: LIGGGHTS stopped. The end of %s:\n", LastWords::log_name);
    for (const auto& line : last)
        std::fprintf(stderr, "  | %s\n", line.c_str());
    std::fprintf(stderr, "  remedy: the line before ERROR is the command of the script that it refers to\n");
}

void show_at_exit()
{
    if (speaking) show();
}

}  // namespace

LastWords::LastWords(bool speaks)
{
    static const int registered = std::atexit(show_at_exit);
    static_cast<void>(registered);
    listening = true;
    speaking = speaks;
}

LastWords::~LastWords() { listening = speaking = false; }

}  // namespace interphase

/// LIGGGHTS's errors of a single rank go straight to MPI_Abort, which runs no exit handler. MPI lets a program wrap its
/// calls in this way (MPI standard, profiling interface).
extern "C" int MPI_Abort(MPI_Comm comm, int code)
{
    // often all ranks abort for the same reason; the one that speaks for all ends the others meanwhile
    if (interphase::listening && !interphase::speaking) std::this_thread::sleep_for(std::chrono::seconds(1));
    if (interphase::listening) interphase::show();
    return PMPI_Abort(comm, code);
}
