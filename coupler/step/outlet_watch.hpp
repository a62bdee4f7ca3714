// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/archive.hpp"
#include "base/count.hpp"
#include "step/gas.hpp"
#include "step/visitors.hpp"

namespace interphase {

/// Counts particles that the gas holds under an outlet above them which lets gas through and no particles, such as a
/// packed slug below the top of a vessel: in a cell that the gas leaves upwards through the outer boundary, packed, at
/// rest, and with a pressure drop that bears them.
class OutletWatch {
public:
    OutletWatch(const Gas& gas, const Vector& gravity);

    /// After the gas was solved: its full pressure's gradient [n x 3, Pa/m] and the voidage [n] of the own cells.
    void observe(const Visitors& visitors, const Scalars& voidage, const Scalars& pressure_gradient);

    Count count() const;  ///< of this rank

    void keep(Archive& archive) { archive.keep_share("held", held_); }

private:
    const Gas& gas_;
    Vector gravity_;               ///< [m/s2]
    std::vector<OpenFace> above_;  ///< of the own cells: open faces that gravity points away from
    long held_ = 0;
};

}  // namespace interphase
