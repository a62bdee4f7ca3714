// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engines/openfoam/gas_fields.hpp"

namespace interphase {

/// A gas that stays as the case's fields give it: for particles in a known flow.
class FrozenGas : public GasFields {
public:
    using GasFields::GasFields;
    void solve(double, const Scalars&, const Scalars&) override {}
    double courant_number() const override { return 0; }
};

}  // namespace interphase
