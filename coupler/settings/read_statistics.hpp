// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "settings/reader.hpp"
#include "settings/statistics_settings.hpp"

namespace interphase {

/// What the block `statistics` asks for, with what only tools/report looks at known and checked, too. Throws a
/// UserError that names file, line, value and remedy.
void read_statistics(Reader& block, StatisticsSettings& settings);

}  // namespace interphase
