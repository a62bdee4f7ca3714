// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "IOdictionary.H"
#include "incompressible/transportModel/transportModel.H"
#include "uniformDimensionedFields.H"
#include "volFields.H"

namespace interphase {

/// constant/transportProperties with its constant rho [kg/m3] and mu [Pa s], and the viscosity mu / rho for those in
/// OpenFOAM that look for a transport model of this name.
class GasTransport : public Foam::IOdictionary, public Foam::transportModel {
public:
    explicit GasTransport(const Foam::fvMesh& mesh);

    const Foam::dimensionedScalar& density() const { return density_; }
    const Foam::dimensionedScalar& viscosity() const { return viscosity_; }  ///< dynamic

    Foam::tmp<Foam::volScalarField> nu() const override;
    Foam::tmp<Foam::scalarField> nu(Foam::label patch) const override;
    void correct() override {}
    bool read() override { return true; }

private:
    const Foam::fvMesh& mesh_;
    Foam::dimensionedScalar density_, viscosity_;
};

/// The gas's properties from constant/transportProperties (rho, mu), constant/g and, where there is one, constant/hRef.
/// Under the names that OpenFOAM's solvers use they are in the registry of the mesh, where boundary conditions and
/// function objects look for them: the density as a field `rho`, `nu` in `transportProperties`, `g`, `hRef`, `gh`. To
/// be made before fields whose boundary conditions may ask for them.
class GasProperties {
public:
    /// `mesh` outlives this.
    explicit GasProperties(const Foam::fvMesh& mesh);

    const GasTransport& transport() const { return transport_; }
    const Foam::dimensionedScalar& density() const { return transport_.density(); }      ///< [kg/m3]
    const Foam::dimensionedScalar& viscosity() const { return transport_.viscosity(); }  ///< dynamic [Pa s]
    const Foam::uniformDimensionedVectorField& gravity() const { return gravity_; }      ///< [m/s2]

    /// p less p_rgh, over density: g.x from the level hRef on, as OpenFOAM's solvers count it [m2/s2].
    const Foam::volScalarField& height_potential() const { return height_potential_; }

private:
    GasTransport transport_;
    const Foam::uniformDimensionedVectorField& gravity_;
    Foam::uniformDimensionedScalarField reference_height_;
    Foam::volScalarField density_field_, height_potential_;
};

/// A UserError for a property that is not positive; `dictionary` names the file.
double positive_property(const Foam::dictionary& dictionary, const char* name);

}  // namespace interphase
