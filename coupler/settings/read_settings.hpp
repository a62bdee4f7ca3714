// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "settings/dictionary.hpp"
#include "settings/key.hpp"
#include "settings/settings.hpp"

namespace interphase {

/// What system/couplingDict asks for. Throws a UserError that names file, line, value and remedy.
/// @param scene  the scene's own numbers: couplingDict includes them, so that they stand beside its keys
/// @param folder of the case, where the script is
/// @param source of the methods; collective, so that all of this is
Settings read_settings(const Dictionary& coupling, const Dictionary& scene, const std::filesystem::path& folder,
                       const MethodSource& source);

/// Every key that read_settings() asks for, those of a block together.
std::vector<KeyDescription> setting_keys(const MethodSource& source);

}  // namespace interphase
