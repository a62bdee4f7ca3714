// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "plugin/plugin.hpp"

namespace interphase {

/// What keeps a plug-in from being used by this program and what to do, or nothing: another interface version, or
/// anything that it was built against otherwise than this program was.
struct Misfit {
    std::string what, remedy;
};
std::optional<Misfit> misfit_of(const PluginDescriptor& plugin);

}  // namespace interphase
