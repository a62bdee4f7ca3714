// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engines/openfoam/gas_properties.hpp"
#include "turbulentTransportModel.H"

namespace interphase {

/// The viscous stress of a laminar gas among particles, tau = mu (grad u + (grad u)^T - 2/3 div u I), of which the
/// gas's momentum equation and a wall feel the share eps. The gas solver takes it from here, and so do function objects
/// and boundary conditions: in OpenFOAM's registry it is the incompressible turbulence model, so that `forces`,
/// `wallShearStress`, `yPlus` report what the solver solved.
class GasStress : public Foam::incompressible::turbulenceModel {
public:
    /// `phi` of the gas velocity U, `superficial_phi` of eps U [m3/s]. All of them outlive this.
    GasStress(const GasTransport& transport, const Foam::volScalarField& voidage, const Foam::volVectorField& U,
              const Foam::surfaceScalarField& superficial_phi, const Foam::surfaceScalarField& phi);

    /// -eps tau / rho [m2/s2].
    Foam::tmp<Foam::volSymmTensorField> devReff() const override;
    /// The force -div(eps tau) / rho per volume, implicit in U.
    Foam::tmp<Foam::fvVectorMatrix> divDevReff(Foam::volVectorField& U) const override;
    Foam::tmp<Foam::volSymmTensorField> devRhoReff() const override { return devReff(); }
    Foam::tmp<Foam::fvVectorMatrix> divDevRhoReff(Foam::volVectorField& U) const override { return divDevReff(U); }

    Foam::tmp<Foam::volScalarField> nuEff() const override { return nu(); }
    Foam::tmp<Foam::scalarField> nuEff(Foam::label patch) const override { return nu(patch); }

    /// Laminar: all of these are zero.
    Foam::tmp<Foam::volScalarField> nut() const override;
    Foam::tmp<Foam::scalarField> nut(Foam::label patch) const override;
    Foam::tmp<Foam::volScalarField> k() const override;
    Foam::tmp<Foam::volScalarField> epsilon() const override;
    Foam::tmp<Foam::volSymmTensorField> R() const override;

    bool read() override { return true; }
    const Foam::dictionary& coeffDict() const override { return Foam::dictionary::null; }
    void correct() override {}

private:
    const Foam::dimensionedScalar nu_;
    const Foam::volScalarField& voidage_;
};

}  // namespace interphase
