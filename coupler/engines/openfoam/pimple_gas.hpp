// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engines/openfoam/gas_fields.hpp"
#include "fvMatrices.H"
#include "pimpleControl.H"
#include "surfaceFields.H"

namespace interphase {

/// Volume-averaged incompressible flow, by PIMPLE (PISO with one outer corrector):
///     d(eps)/dt + div(eps u) = 0
///     d(rho eps u)/dt + div(rho eps u u) = -eps grad p + div(eps tau) + rho eps g - (rate u - source)
/// with p_rgh = p - rho g.x, and the exchange with the particles implicit in u: its coefficient is part of the matrix
/// diagonal, so it holds for the velocity at the end of the step, to round-off, after every pressure correction.
/// Schemes, solvers and boundary conditions are the case's. Laminar.
class PimpleGas : public GasFields {
public:
    explicit PimpleGas(Foam::fvMesh& mesh);

    void solve(double dt, const Scalars& rate, const Scalars& source) override;
    double courant_number() const override;

private:
    void correct_pressure(Foam::fvVectorMatrix& momentum, const Foam::volScalarField& voidage_rate,
                          const Foam::surfaceScalarField& face_voidage);

    Foam::surfaceScalarField phi_;           ///< of u [m3/s]
    Foam::volScalarField::Internal rate_;    ///< over density [1/s]
    Foam::volVectorField::Internal source_;  ///< over density [m/s2]
    Foam::pimpleControl control_;
    Foam::label reference_cell_ = 0;
    Foam::scalar reference_pressure_ = 0;
};

}  // namespace interphase
