// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/way_to_prepare.hpp"

#include <filesystem>

namespace interphase {

std::string way_to_prepare()
{
    namespace files = std::filesystem;
    std::string steps;
    const auto add = [&steps](const std::string& step) { steps += (steps.empty() ? "" : ", ") + step; };
    if (files::exists("prepare")) add("./prepare with the tree's python/ on PYTHONPATH");
    if (files::exists("system/blockMeshDict")) add("blockMesh");
    add("decomposePar for several ranks");
    return "`tools/run " + files::current_path().string() +
           "` makes a copy of the case ready and runs it; by hand: " + steps;
}

}  // namespace interphase
