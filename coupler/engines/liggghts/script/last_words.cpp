// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/script/last_words.hpp"

#include <dlfcn.h>
#include <mpi.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

#include "base/stop_together.hpp"
#include "base/user_error.hpp"
#include "base/way_to_prepare.hpp"
#include "comm.h"
#include "compute.h"
#include "error.h"
#include "fix.h"
#include "update.h"

namespace interphase {

namespace {

bool listening = false;
bool natively = false;  // where nobody listens
bool speaking = false;
bool heard = false;
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

std::string quoted(const std::deque<std::string>& lines)
{
    std::string all;
    for (const std::string& line : lines)
        all += "\n  | " + line;
    return all;
}

/// The file that LIGGGHTS says it cannot open, where there is none of that name; empty otherwise.
std::string missing_file(const std::deque<std::string>& lines)
{
    if (lines.empty()) return "";
    static const std::regex words("ERROR.*Cannot open (?:\\S+ )*?(?:file|script) (\\S+)");
    std::smatch found;
    if (!std::regex_search(lines.back(), found, words)) return "";
    return std::filesystem::exists(found.str(1)) ? "" : found.str(1);
}

/// What is known once LIGGGHTS has said that it stops, in the script or in a run.
Problem last_words(bool in_run)
{
    std::fflush(nullptr);  // of LIGGGHTS's own stream above all
    Problem problem;
    problem.kind = ExitCode::liggghts;
    const std::string log = LastWords::log_name;
    if (own_words.empty()) {
        std::ifstream file(log);
        const std::deque<std::string> lines = last_lines(file);
        problem.what = "LIGGGHTS stopped. The end of " + log + ":" + quoted(lines);
        problem.remedy = "the line before ERROR is the command of the script that it refers to";
        if (const std::string missing = missing_file(lines); !missing.empty() && !in_run) {
            problem.what =
                "the script reads `" + missing + "`, which is not there. The end of " + log + ":" + quoted(lines);
            problem.where = std::filesystem::current_path().string();
            problem.remedy = std::filesystem::exists("prepare")
                                 ? way_to_prepare()
                                 : "name the file as it is called from there, or put it there";
        }
    } else {
        std::istringstream own(own_words);
        problem.what = "LIGGGHTS stopped, on one rank only. Its last words there:" + quoted(last_lines(own));
        problem.remedy = "correct the script accordingly; the commands so far stand in " + log;
    }
    if (in_run) problem.remedy = "do what the words after ERROR ask for; what LIGGGHTS said before stands in " + log;
    return problem;
}

/// Where LIGGGHTS ends the process by other ways than its errors.
[[noreturn]] void stop_process()
{
    const Problem problem = last_words(true);
    listening = speaking = false;
    stop_together("interphase", failure_of(UserError(problem)));
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
    if (!listening) return;
    int finalized = 0;
    MPI_Finalized(&finalized);
    if (!finalized) stop_process();
    if (speaking) std::fprintf(stderr, "\ninterphase: error: %s\n", last_words(true).message().c_str());
    _exit(static_cast<int>(ExitCode::liggghts));
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

bool LastWords::heard_error() { return heard; }

LastWords::~LastWords() { listening = speaking = false; }

NativeWords::NativeWords() { natively = true; }
NativeWords::~NativeWords() { natively = false; }

namespace {

/// What LIGGGHTS's own function, of which ours has taken the place, does where nobody listens.
template <class... Arguments>
void do_as_liggghts_does(const char* function, Arguments... arguments)
{
    using Function = void (*)(Arguments...);
    if (const auto own = reinterpret_cast<Function>(dlsym(RTLD_NEXT, function))) own(arguments...);
    std::_Exit(static_cast<int>(ExitCode::liggghts));  // it does not come back
}

/// An error as a UserError. LIGGGHTS would wait for all ranks first, for ever where only one has called it so, and
/// where it is in the mood add a joke from memory that it has freed (error_special.h).
[[noreturn]] void stop(std::FILE* screen, std::FILE* log, const std::string& words, bool in_run)
{
    heard = true;
    if (natively) {
        std::fflush(screen);
        if (log) std::fputs((words + "\n").c_str(), log);
        std::fflush(log);
        // exit code 1, as of the packaged program
        throw UserError("LIGGGHTS stopped:\n  | " + words, "", "correct the script accordingly");
    }
    if (screen) std::fputs((words + "\n").c_str(), screen);
    const Problem problem = last_words(in_run);
    listening = speaking = false;
    throw UserError(problem);
}

bool runs(const LAMMPS_NS::Update* update) { return update && update->whichflag != 0; }

std::string placed(const std::string& words, const char* file, int line)
{
    return words + " (" + file + ":" + std::to_string(line) + ")";
}

std::string of_command(const char* kind, const char* style, const char* id, const char* words)
{
    const std::string kind_style = std::string(kind) + " " + style + " (id " + id + ")";
    if (std::strlen(words) <= 2) return "ERROR: Illegal " + kind_style + " command";
    return "ERROR: " + kind_style + ": " + words;
}

}  // namespace

}  // namespace interphase

// A function that the program defines takes the place of a library's in all its calls, also in the library's own.

namespace LAMMPS_NS {

using interphase::listening;
using interphase::natively;

void Error::all(const char* file, int line, const char* words)
{
    if (!listening && !natively)
        interphase::do_as_liggghts_does("_ZN9LAMMPS_NS5Error3allEPKciS2_", this, file, line, words);
    interphase::stop(screen, logfile, interphase::placed(std::string("ERROR: ") + words, file, line),
                     interphase::runs(update));
}

void Error::one(const char* file, int line, const char* words)
{
    if (!listening && !natively)
        interphase::do_as_liggghts_does("_ZN9LAMMPS_NS5Error3oneEPKciS2_", this, file, line, words);
    const std::string start = "ERROR on proc " + std::to_string(comm->me) + ": ";
    interphase::stop(screen, logfile, interphase::placed(start + words, file, line), interphase::runs(update));
}

void Error::fix_error(const char* file, int line, Fix* fix, const char* style, const char* words)
{
    if (!listening && !natively)
        interphase::do_as_liggghts_does("_ZN9LAMMPS_NS5Error9fix_errorEPKciPNS_3FixES2_S2_", this, file, line, fix,
                                        style, words);
    interphase::stop(screen, logfile,
                     interphase::placed(interphase::of_command("Fix", style, fix->id, words), file, line),
                     interphase::runs(update));
}

void Error::compute_error(const char* file, int line, Compute* compute, const char* words)
{
    if (!listening && !natively)
        interphase::do_as_liggghts_does("_ZN9LAMMPS_NS5Error13compute_errorEPKciPNS_7ComputeES2_", this, file, line,
                                        compute, words);
    interphase::stop(
        screen, logfile,
        interphase::placed(interphase::of_command("Compute", compute->style, compute->id, words), file, line),
        interphase::runs(update));
}

void Error::done()
{
    if (!listening) interphase::do_as_liggghts_does("_ZN9LAMMPS_NS5Error4doneEv", this);
    interphase::stop(screen, logfile, "ERROR: the script asked LIGGGHTS to quit", interphase::runs(update));
}

}  // namespace LAMMPS_NS

/// Some of LIGGGHTS's errors go straight to MPI_Abort, which runs no exit handler. MPI lets a program wrap its calls in
/// this way (MPI standard, profiling interface).
extern "C" int MPI_Abort(MPI_Comm comm, int code)
{
    if (interphase::listening) interphase::stop_process();
    interphase::end_all_ranks(comm, code);
}
