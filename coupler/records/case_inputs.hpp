// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace interphase {

/// A file that a run was started from.
struct InputFile {
    std::string path;  ///< from the case folder on
    std::uintmax_t bytes = 0;
    std::string sha256;               ///< empty where it is larger than `longest_hashed` or may not be read
    std::optional<std::string> text;  ///< of a text of at most `longest_kept` bytes
};

constexpr std::uintmax_t longest_kept = 64 << 10;    ///< [bytes]
constexpr std::uintmax_t longest_hashed = 64 << 20;  ///< [bytes], a quarter of a second

/// The files of a case, sorted by path: those of system/, constant/ and 0/ with their subfolders, the LIGGGHTS script,
/// and what these name with `#include`, or `include`, `jump`, `read_data`, `read_restart`, `molecule` and the `file` of
/// a mesh. `variables` of the script are put in for ${NAME}. Left out: files outside of the case folder, and
/// names with variables that only the script knows.
std::vector<InputFile> case_inputs(const std::filesystem::path& case_folder, const std::string& script,
                                   const std::vector<std::pair<std::string, std::string>>& variables);

}  // namespace interphase
