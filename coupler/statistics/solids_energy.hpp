// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/communicator.hpp"
#include "step/solids.hpp"

namespace interphase {

/// Of all particles [J].
struct SolidsEnergy {
    double translation = 0;  ///< sum m v^2/2
    double rotation = 0;     ///< sum I w^2/2 with I = 2/5 m r^2 of the tracked sphere
    double potential = 0;    ///< in gravity, 0 with the centre at the `floor`
};

/// `floor`: height of it against gravity, from the origin [m]. Collective.
SolidsEnergy solids_energy(const Communicator& comm, Solids& solids, double floor);

}  // namespace interphase
