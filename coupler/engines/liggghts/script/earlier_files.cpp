// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/script/earlier_files.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "base/free_name.hpp"
#include "base/text.hpp"
#include "engines/liggghts/script/last_words.hpp"

namespace interphase {

namespace {

namespace fs = std::filesystem;

EarlierFiles* watched = nullptr;

}  // namespace

EarlierFiles::Watch::Watch(EarlierFiles& files)
{
    if (files.goes_on_) watched = &files;
}

EarlierFiles::Watch::~Watch() { watched = nullptr; }

bool EarlierFiles::put_aside(const std::string& file)
{
    std::error_code wrong;
    const std::uintmax_t size = fs::is_regular_file(file, wrong) ? fs::file_size(file, wrong) : 0;
    const bool own = std::any_of(moved_.begin(), moved_.end(), [&](const Moved& moved) { return moved.name == file; });
    if (wrong || size == 0 || own) return true;  // nothing is lost, or it is of this run
    const std::string aside = free_name(file, "before-resume");
    fs::rename(file, aside, wrong);
    if (wrong) {
        errno = wrong.value();
        return false;
    }
    moved_.push_back({file, aside});
    return true;
}

std::optional<Problem> EarlierFiles::keep(double time)
{
    std::string names;
    for (const Moved& moved : moved_) {
        const std::string name = free_name(moved.name, "until-" + text(time));
        std::error_code wrong;
        fs::rename(moved.aside, name, wrong);
        names += (names.empty() ? "" : ", ") + (wrong ? moved.aside : name);
    }
    moved_.clear();
    if (names.empty()) return std::nullopt;
    return Problem{"files that the script begins anew when a run goes on stay under other names: " + names,
                   "the case's folder", "none is needed; rows may reach beyond t = " + text(time) + " s there"};
}

EarlierFiles::~EarlierFiles()
{
    std::error_code ignored;
    for (const Moved& moved : moved_)
        fs::rename(moved.aside, moved.name, ignored);
}

}  // namespace interphase

/// A function that the program defines takes the place of a library's in all its calls. LIGGGHTS opens what it writes
/// by this one, and gives nobody a word in it.
extern "C" std::FILE* fopen(const char* name, const char* mode)
{
    using Function = std::FILE* (*)(const char*, const char*);
    static const auto own = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "fopen"));
    if (interphase::watched && name && mode && mode[0] == 'w') {
        if (std::string(name) == interphase::LastWords::log_name) return own(name, "a");
        if (!interphase::watched->put_aside(name)) return nullptr;
    }
    return own(name, mode);
}
