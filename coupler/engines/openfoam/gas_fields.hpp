// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engines/openfoam/gas_addressing.hpp"
#include "engines/openfoam/gas_properties.hpp"
#include "engines/openfoam/gas_stress.hpp"
#include "engines/openfoam/mesh_part.hpp"
#include "fvMesh.H"
#include "run/case_gas.hpp"
#include "surfaceFields.H"
#include "uniformDimensionedFields.H"
#include "volFields.H"

namespace interphase {

class GasState;

/// Mesh and fields that every gas model has: U [m/s], p_rgh and p [Pa], voidage, the fluxes phi of U and voidagePhi of
/// eps U (the superficial one) [m3/s], and the gas's properties and stress. All of them are in OpenFOAM's registry, by
/// these names, for boundary conditions and function objects.
class GasFields : public CaseGas {
public:
    /// `mesh` outlives this.
    explicit GasFields(Foam::fvMesh& mesh);

    const MeshView& mesh() const override { return part_.view(); }
    const CellLocator& locator() const override { return part_; }
    Vectors translations() const override { return part_.translations(); }
    GasProperty density() const override { return rho_.value(); }
    GasProperty viscosity() const override { return mu_.value(); }
    void set_voidage(const Scalars& voidage) override;
    Scalars velocity() const override;
    Scalars pressure_gradient() const override;
    Scalars velocity_gradient() const override;
    Scalars viscous_force() const override;
    Scalars gradient(const Scalars& of_cells) const override;
    Scalars stretching(const Scalars& flow) const override;
    void write_along(const std::vector<CellField>& fields) override;
    std::optional<Problem> trouble() const override;
    double pressure_at(const Vector& point) const override;
    double total_volume() const override;
    Box bounds() const override;
    Vector gravity() const override;
    void keep(Archive& archive) override;

protected:
    /// The fields that the next step depends on.
    virtual void keep_fields(GasState& state);

    /// p from p_rgh.
    void update_pressure();

    Foam::fvMesh& mesh_;
    MeshPart part_;
    const GasAddressing addressing_;
    const GasProperties properties_;
    const Foam::uniformDimensionedVectorField& g_;
    const Foam::dimensionedScalar rho_;
    const Foam::dimensionedScalar mu_;
    Foam::volVectorField U_;
    Foam::volScalarField p_rgh_;
    Foam::volScalarField voidage_;
    Foam::volScalarField p_;
    Foam::surfaceScalarField phi_;
    Foam::surfaceScalarField superficial_phi_;
    const GasStress stress_;
};

/// `type` on every patch of the mesh but where the patch itself constrains it (empty, cyclic, symmetry, processor,
/// ...).
Foam::wordList patch_types(const Foam::fvMesh& mesh, const Foam::word& type);

}  // namespace interphase
