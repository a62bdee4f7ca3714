// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/plugins/plugin_search.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "base/text.hpp"
#include "base/user_error.hpp"

namespace interphase {

namespace {

namespace fs = std::filesystem;

constexpr const char* prefix = "lib";
constexpr const char* suffix = ".so";

bool ends_with(const std::string& text, const std::string& end)
{
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string find_by_path(const std::string& wanted, const std::string& asked_by)
{
    std::error_code unreachable;
    const fs::path path = fs::absolute(wanted, unreachable).lexically_normal();
    if (fs::is_regular_file(path, unreachable)) return path;
    const char* problem = fs::is_directory(path, unreachable) ? "is a folder" : "is not there";
    throw UserError("the plug-in `" + wanted + "` " + problem + " (" + path.string() + ")", asked_by,
                    "give the shared library's path, absolute or from the current folder (the case's); build it if it "
                    "is not built");
}

}  // namespace

std::vector<std::string> plugin_folders()
{
    std::vector<std::string> folders;
    if (const char* listed_folders = std::getenv("INTERPHASE_PLUGIN_PATH")) {
        std::istringstream list(listed_folders);
        for (std::string folder; std::getline(list, folder, ':');)
            if (!folder.empty()) folders.push_back(folder);
    }
    std::error_code unknown;
    const fs::path program = fs::read_symlink("/proc/self/exe", unknown).parent_path();
    if (!unknown) {
        folders.push_back(program / "plugins");
        folders.push_back((program / "../lib/interphase/plugins").lexically_normal());
    }
    return folders;
}

std::vector<std::string> plugins_at_hand()
{
    std::vector<std::string> names;
    for (const auto& folder : plugin_folders()) {
        std::error_code unreadable;
        for (const auto& entry : fs::directory_iterator(folder, unreadable)) {
            const std::string file = entry.path().filename();
            if (file.rfind(prefix, 0) == 0 && ends_with(file, suffix)) names.push_back(file.substr(3, file.size() - 6));
        }
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

std::string find_plugin(const std::string& wanted, const std::string& asked_by)
{
    if (wanted.find('/') != std::string::npos) return find_by_path(wanted, asked_by);

    const std::vector<std::string> folders = plugin_folders();
    std::string places;
    for (const auto& folder : folders) {
        const fs::path path = fs::path(folder) / (prefix + wanted + suffix);
        std::error_code unreachable;
        if (fs::is_regular_file(path, unreachable)) return fs::absolute(path, unreachable).lexically_normal();
        places += (places.empty() ? "" : ", ") + folder;
    }

    const std::vector<std::string> known = plugins_at_hand();
    const std::string near = nearest_name(wanted, known);
    std::string remedy = near.empty() ? "" : "did you mean `" + near + "`? ";
    if (ends_with(wanted, suffix)) remedy += "for a file write its path with a slash, such as `./" + wanted + "`; ";
    remedy += known.empty() ? "no plug-in is there at all: build one, or " : "there: " + listed(known) + "; else ";
    remedy += "give its path, or its folder in INTERPHASE_PLUGIN_PATH";
    throw UserError("there is no plug-in `" + wanted + "`: no " + prefix + wanted + suffix + " in " + places, asked_by,
                    remedy);
}

}  // namespace interphase
