// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace interphase {

/// What a run has recorded in `folder`, in words, e.g. "results.h5 (120 rows, to t = 1.2 s)"; nothing where there is no
/// row and no snapshot after the start. A file that cannot be read counts as recorded.
std::optional<std::string> earlier_records(const std::filesystem::path& folder);

}  // namespace interphase
