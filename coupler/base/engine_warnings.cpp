// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/engine_warnings.hpp"

#include <mpi.h>

#include <cctype>
#include <sstream>

namespace interphase {

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::string in_one_line(const std::string& words)
{
    std::istringstream stream(words);
    std::string line;
    for (std::string word; stream >> word;)
        line += (line.empty() ? "" : " ") + word;
    return line;
}

bool is_of_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The words without their numbers. What can be part of one next to a digit (1.5e-07) goes with it; digits of a name
/// (wall2) stay.
std::string kind_of(const std::string& words)
{
    std::string kind;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (!is_digit(words[i]) || (!kind.empty() && (is_of_name(kind.back()) || is_digit(kind.back())))) {
            kind += words[i];
            continue;
        }
        while (!kind.empty() && (kind.back() == '-' || kind.back() == '+' || kind.back() == '.'))
            kind.pop_back();
        while (i + 1 < words.size() &&
               (is_digit(words[i + 1]) ||
                (i + 2 < words.size() && std::string(".eE+-").find(words[i + 1]) != std::string::npos &&
                 (is_digit(words[i + 2]) || words[i + 2] == '-' || words[i + 2] == '+'))))
            ++i;
        kind += '#';
    }
    return kind;
}

/// Each rank's words, in rank order. Words hold no line ends.
std::vector<std::string> gathered(const Communicator& comm, const std::vector<std::string>& mine)
{
    std::string lines;
    for (const std::string& words : mine)
        lines += words + "\n";
    const auto lengths = comm.all_gather(Scalars{static_cast<double>(lines.size())});
    std::vector<int> counts, starts;
    int total = 0;
    for (const double length : lengths) {
        counts.push_back(static_cast<int>(length));
        starts.push_back(total);
        total += counts.back();
    }
    std::string all(static_cast<std::size_t>(total), ' ');
    MPI_Allgatherv(lines.data(), static_cast<int>(lines.size()), MPI_CHAR, all.data(), counts.data(), starts.data(),
                   MPI_CHAR, comm.handle());
    std::vector<std::string> found;
    std::istringstream stream(all);
    for (std::string line; std::getline(stream, line);)
        found.push_back(line);
    return found;
}

}  // namespace

EngineWarnings::EngineWarnings(std::string engine, std::string log)
    : engine_(std::move(engine)), log_(std::move(log)), key_("warnings_of_" + engine_), text_("warnings of " + engine_)
{
    kind_.key = key_.c_str();
    kind_.text = text_.c_str();
}

void EngineWarnings::hear(const std::string& words)
{
    const std::string line = in_one_line(words);
    if (line.empty()) return;
    ++heard_;
    if (known_.insert(kind_of(line)).second) fresh_.push_back(line);
}

std::vector<std::string> EngineWarnings::news(const Communicator& comm)
{
    if (!comm.any(!fresh_.empty())) return {};
    std::vector<std::string> first;
    for (const std::string& words : gathered(comm, fresh_)) {
        const std::string kind = kind_of(words);
        known_.insert(kind);
        if (told_.insert(kind).second) first.push_back(words);
    }
    fresh_.clear();
    return first;
}

}  // namespace interphase
