// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engines/openfoam/gas_fields.hpp"
#include "surfaceInterpolate.H"

namespace interphase {

/// A gas that stays as the case's fields give it: for particles in a known flow.
class FrozenGas : public GasFields {
public:
    using GasFields::GasFields;
    void solve(double, const Demand&) override { superficial_phi_ = Foam::fvc::interpolate(voidage_) * phi_; }
    Scalars outflow() const override { return Scalars(part_.view().size(), 0.0); }
    Crossing crossing() const override { return {}; }
    double courant_number() const override { return 0; }
};

}  // namespace interphase
