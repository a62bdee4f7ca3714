// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/script/listening_screen.hpp"

#include <strings.h>

#include <cctype>

namespace interphase {

ListeningScreen::ListeningScreen(std::FILE*& screen, EngineWarnings& warnings) : before_(screen), warnings_(warnings)
{
    std::fflush(before_);
    own_ = fopencookie(this, "w", {nullptr, write, nullptr, close});
    if (own_) screen = own_;
}

ListeningScreen::~ListeningScreen()
{
    // LIGGGHTS closes its screen only where it ends the process
    if (own_) std::fclose(own_);
}

void ListeningScreen::flush()
{
    if (own_) std::fflush(own_);
}

ssize_t ListeningScreen::write(void* self, const char* text, std::size_t size)
{
    auto& screen = *static_cast<ListeningScreen*>(self);
    std::fwrite(text, 1, size, screen.before_);
    std::fflush(screen.before_);  // a process that ends now flushes streams in an order that nobody knows
    screen.hear(text, size);
    return static_cast<ssize_t>(size);
}

int ListeningScreen::close(void* self)
{
    auto& screen = *static_cast<ListeningScreen*>(self);
    screen.own_ = nullptr;
    return std::fclose(screen.before_);
}

void ListeningScreen::hear(const char* text, std::size_t size)
{
    for (const char* c = text; c != text + size; ++c) {
        if (*c != '\n') {
            line_ += *c;
            continue;
        }
        warnings_.hear(warning_in(line_));
        line_.clear();
    }
}

std::string warning_in(const std::string& line)
{
    constexpr const char* mark = "WARNING";
    constexpr std::size_t length = 7;
    const std::size_t start = line.find_first_not_of(" \t");
    if (start == std::string::npos || strncasecmp(line.c_str() + start, mark, length) != 0) return "";
    std::size_t begin = start + length;
    if (begin < line.size() && std::isalnum(static_cast<unsigned char>(line[begin]))) return "";
    begin = line.find_first_not_of(" :!", begin);
    if (begin == std::string::npos) return "";
    std::string words = line.substr(begin);
    const std::size_t place = words.rfind(" (");  // (.../src/fix_insert.cpp:123)
    const bool ends_with_place =
        place != std::string::npos && words.back() == ')' &&
        (words.find(".cpp:", place) != std::string::npos || words.find(".h:", place) != std::string::npos);
    return ends_with_place ? words.substr(0, place) : words;
}

}  // namespace interphase
