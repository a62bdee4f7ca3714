// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/vector.hpp"
#include "mapping/mapping_type.hpp"
#include "settings/method.hpp"
#include "settings/statistics_settings.hpp"

namespace interphase {

enum class GasModel { pimple, frozen, none };
enum class OutsideMesh { stop, ignore };

/// Commands of LIGGGHTS for the script's scene, at a time of the run.
struct TimedCommands {
    std::string name;
    double time = 0;  ///< before the first gas step that begins then or later [s]
    std::vector<std::string> lines;
};

/// What system/couplingDict asks for. Lengths in m, times in s, pressures in Pa.
struct Settings {
    Method method;                     ///< who handles collisions
    double weight = 1;                 ///< real particles per tracked one, >= 1, unless the script gives each its own
    std::vector<std::string> plugins;  ///< names or paths of plug-ins with fix styles for the script

    std::string script;                                          ///< LIGGGHTS script, relative to the case
    std::vector<std::pair<std::string, std::string>> variables;  ///< handed to the script
    std::vector<TimedCommands> commands;                         ///< in the order of their times
    double solid_step = 0;                                       ///< given solid step [s]; 0: derived
    double steps_per_collision = 20;                             ///< S: solid step = t_c / S
    double largest_overlap = 0;    ///< [tracked diameter]; above 0: solid step = that overlap at impact_speed
    double impact_speed = 0;       ///< [m/s]
    double step_at_time_zero = 0;  ///< of LIGGGHTS's count

    GasModel gas = GasModel::pimple;
    bool two_way = true;  ///< whether the particles act on the gas

    std::string drag_law = "BVK";
    bool self_disturbance = true;     ///< whether drag takes out what a particle sees of itself; two-way only
    std::vector<std::string> forces;  ///< interphase terms beside drag and pressure gradient (forces/terms.hpp)

    MappingRules mapping;
    OutsideMesh outside_mesh = OutsideMesh::stop;

    double record_interval = 0.05;          ///< between two rows of the series [s]
    double snapshot_interval = 0;           ///< between two particle snapshots [s]; 0: as the gas fields are written
    double checkpoint_interval = 0;         ///< between two checkpoints, simulated time [s]; 0: none for it
    double checkpoint_wall_interval = 600;  ///< likewise, of the wall clock [s]; 0: none by the clock
    std::vector<Vector> pressure_taps;      ///< two points or more; the first's pressure less the last's is recorded
    StatisticsSettings statistics;
};

}  // namespace interphase
