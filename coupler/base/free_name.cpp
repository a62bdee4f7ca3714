// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/free_name.hpp"

#include <filesystem>

namespace interphase {

std::string free_name(const std::string& file, const std::string& words)
{
    const std::string name = file + "-" + words;
    std::string numbered = name;
    for (int number = 2; std::filesystem::exists(numbered); ++number)
        numbered = name + "-" + std::to_string(number);
    return numbered;
}

}  // namespace interphase
