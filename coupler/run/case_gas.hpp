// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/archive.hpp"
#include "step/gas.hpp"

namespace interphase {

/// The gas of a case on disk, whichever engine and model solve it.
class CaseGas : public Gas {
public:
    /// Largest Courant number of the last step, of the interstitial velocity. Collective.
    virtual double courant_number() const = 0;

    /// The pressure [Pa] of the cell that holds `point`. Throws a UserError where no cell does. Collective.
    virtual double pressure_at(const Vector& point) const = 0;

    virtual double total_volume() const = 0;  ///< of the mesh [m3]. Collective.
    virtual Box bounds() const = 0;           ///< of the whole mesh [m]

    virtual Vector gravity() const = 0;  ///< [m/s2]

    /// Between two solve(): all that the next ones depend on, beside the case's clock, which is kept before.
    virtual void keep(Archive& archive) = 0;
};

}  // namespace interphase
