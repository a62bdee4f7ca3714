// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace interphase {

/// A UserError where the case in `folder` is not cut into as many parts as there are ranks: folders processor0 and so
/// on, or processorsN of OpenFOAM's collated files. On one rank nothing is asked of it.
void refuse_wrong_decomposition(const std::filesystem::path& folder);

}  // namespace interphase
