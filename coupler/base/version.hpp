// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace interphase {

/// What a program is built from.
struct Version {
    std::string number;               ///< of CMakeLists.txt: "0.1.0"
    std::string commit;               ///< of git, 40 hexadecimal digits; "unknown" where the source is no checkout
    std::string uncommitted_changes;  ///< of tracked files, when it was built: "yes", "no" or "unknown"
    std::string compiler;             ///< "GNU 12.2.0"
    std::string flags;                ///< of the compiler, as CMake has them for every file
    std::string build_type;           ///< of CMake: "Release"
};

/// That of this program. CMake writes the function's source anew when one of them has changed
/// (cmake/RecordVersion.cmake).
Version this_version();

/// "interphase 0.1.0"
inline std::string name_and_number(const Version& version) { return "interphase " + version.number; }

/// Two lines that tell all of it: number and commit, compiler and flags.
std::string description(const Version& version);

}  // namespace interphase
