// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/listening_output.hpp"

#include <algorithm>

namespace interphase {

namespace {

bool starts_with(const std::string& line, const char* start) { return line.rfind(start, 0) == 0; }

/// "[2] " before what a rank says.
void drop_rank(std::string& line)
{
    const std::size_t end = line.find("] ");
    if (line.empty() || line[0] != '[' || end == std::string::npos) return;
    if (std::all_of(line.begin() + 1, line.begin() + static_cast<std::ptrdiff_t>(end),
                    [](char c) { return c >= '0' && c <= '9'; }))
        line.erase(0, end + 2);
}

}  // namespace

int ListeningOutput::overflow(int c)
{
    if (c == traits_type::eof()) return 0;
    const char letter = static_cast<char>(c);
    xsputn(&letter, 1);
    return c;
}

std::streamsize ListeningOutput::xsputn(const char* text, std::streamsize size)
{
    hear(text, size);
    if (log_) log_->sputn(text, size);
    return size;
}

int ListeningOutput::sync() { return log_ ? log_->pubsync() : 0; }

void ListeningOutput::hear(const char* text, std::streamsize size)
{
    for (const char* c = text; c != text + size; ++c) {
        if (*c != '\n') {
            line_ += *c;
            continue;
        }
        hear_line(std::move(line_));
        line_.clear();
    }
}

void ListeningOutput::hear_line(std::string line)
{
    drop_rank(line);
    if (starts_with(line, "--> FOAM ") && line.find("rror :") == std::string::npos) {
        finish_warning();
        warns_ = line.find("Warning") != std::string::npos;
        words_ = warns_ && line.find(':') != std::string::npos ? line.substr(line.find(':') + 1) : "";
        return;
    }
    if (starts_with(line, "--> FOAM Serious Error")) {
        finish_warning();
        warns_ = true;
        return;
    }
    if (!warns_) return;
    if (starts_with(line, "    From function ") || starts_with(line, "    in file ")) return;
    if (starts_with(line, "    Reading ")) {
        read_ = " (r" + line.substr(5) + ")";
        return;
    }
    const bool blank = line.find_first_not_of(' ') == std::string::npos;
    const bool has_words = words_.find_first_not_of(' ') != std::string::npos;
    if (has_words && (blank || !starts_with(line, "    "))) {
        finish_warning();
        return;
    }
    words_ += " " + line;
}

void ListeningOutput::finish_warning()
{
    if (warns_) warnings_.hear(words_ + read_);
    warns_ = false;
    words_.clear();
    read_.clear();
}

}  // namespace interphase
