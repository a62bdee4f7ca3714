// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/script/last_words.hpp"

#include <mpi.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include "base/user_error.hpp"

namespace interphase {

namespace {

bool listening = false;
bool speaking = false;
std::string own_words;  // the end of what LIGGGHTS said on this rank, where it is not the one with the log

constexpr std::size_t most_own_words = 600;

ssize_t keep_the_end(void*, const char* text, std::size_t size)
{
    own_words.append(text, size);
    if (own_words.size() > most_own_words) own_words.erase(0, own_words.size() - most_own_words);
    return static_cast<ssize_t>(size);
}

std::deque<std::string> last_lines(std::istream& words)
{
    constexpr std::size_t count = 6;
    std::deque<std::string> last;
    for (std::string line; std::getline(words, line);) {
        if (line.empty()) continue;
        last.push_back(line);
        if (last.size() > count) last.pop_front();
    }
    return last;
}

void show()
{
    listening = speaking = false;
    std::fflush(nullptr);  // of LIGGGHTS's own stream above all
    std::ifstream log(LastWords::log_name);
    std::istringstream own(own_words);
    const bool from_log = own_words.empty();
    if (from_log)
        std::fprintf(stderr, "\ninterphase: error: LIGGGHTS stopped. The end of %s:\n", LastWords::log_name);
    else
        std::fprintf(stderr, "\ninterphase: error: LIGGGHTS stopped, on one rank only. Its last words there:\n");
    for (const auto& line : last_lines(from_log ? static_cast<std::istream&>(log) : own))
        std::fprintf(stderr, "  | %s\n", line.c_str());
    if (from_log)
        std::fprintf(stderr, "  remedy: the line before ERROR is the command of the script that it refers to\n");
    else
        std::fprintf(stderr, "  remedy: correct the script accordingly; the commands so far stand in %s\n",
                     LastWords::log_name);
}

/// LIGGGHTS ends without a word where it cannot open it.
void make_log()
{
    const std::filesystem::path log = LastWords::log_name;
    std::error_code ignored;
    std::filesystem::create_directories(log.parent_path(), ignored);
    errno = 0;
    if (!std::ofstream(log, std::ios::app))  // what LIGGGHTS has said before stays
        throw UserError("LIGGGHTS's log cannot be written: " + std::string(std::strerror(errno)),
                        std::filesystem::absolute(log).string(),
                        "give yourself the right to write there, or run a copy of the case in a folder of your own "
                        "(tools/run makes one)");
}

void show_at_exit()
{
    if (speaking) show();
}

}  // namespace

LastWords::LastWords(bool speaks)
{
    if (speaks) make_log();
    static const int registered = std::atexit(show_at_exit);
    static_cast<void>(registered);
    listening = true;
    speaking = speaks;
}

std::FILE* LastWords::of_rank_without_log()
{
    std::FILE* stream = fopencookie(nullptr, "w", {nullptr, keep_the_end, nullptr, nullptr});
    if (stream) std::setvbuf(stream, nullptr, _IOLBF, BUFSIZ);
    return stream;
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
