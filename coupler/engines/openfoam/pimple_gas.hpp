// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engines/openfoam/gas_fields.hpp"
#include "fvMatrices.H"
#include "pimpleControl.H"
#include "surfaceFields.H"

namespace interphase {

/// Volume-averaged incompressible flow, by PIMPLE (PISO with one outer corrector). With a Demand's rate, source,
/// following Y, moving M, mobility C, flux A and surplus q, and p_rgh = p - rho g.x,
///     rho (s du/dt + eps u.grad u) = -(eps + Y) grad p + div(eps tau) + rho eps g - (rate u - source)
///     div((eps + M) u + A - C grad p) = q,
/// s the gas share of the step's start (so that the gas's momentum rho s u is kept while s changes by what flows), the
/// second being the continuity of gas and solids together. All of it is implicit in u and p: rate is part of the
/// matrix diagonal, Y and C of the pressure equation, which stays symmetric. So it holds for the velocity at the end of
/// the step, to round-off, after every pressure correction. No solids cross the boundary of the mesh.
///
/// The source and the pressure gradient are summed at the faces, where both are known with the same stencil, and then
/// averaged to the cells: in dense beds and long steps each is many times their sum, and cell by cell the differences
/// between neighbours would escape the flux, and the pressure. (With the part of the source that belongs to the rate in
/// the cells, liquid columns at three relaxation times a step grow waves, and packed beds lose 2 to 4 % more.)
/// Schemes, solvers and boundary conditions are the case's. Laminar.
class PimpleGas : public GasFields {
public:
    explicit PimpleGas(Foam::fvMesh& mesh);

    void solve(double dt, const Demand& demand) override;
    Scalars outflow() const override;
    Crossing crossing() const override;
    std::vector<OpenFace> open_faces() const override;
    double courant_number() const override;

private:
    void keep_fields(GasState& state) override;

    struct Response;

    void refuse_control_of_others() const;
    void refuse_other_time_schemes() const;
    void set_reference_pressure();
    void take(const Demand& demand);
    void correct_pressure(const Foam::fvVectorMatrix& momentum, const Response& response,
                          const Foam::surfaceScalarField& flux_change);
    /// A force over density through the faces [m3/s2], in the cells [m/s2]: as OpenFOAM's reconstruct(), whose tensor
    /// is kept, since it takes longer than all else, and whose sums are one loop instead of three fields (three fifths
    /// of the instructions).
    Foam::tmp<Foam::volVectorField::Internal> in_cells(const Foam::surfaceScalarField& force) const;

    Foam::surfaceScalarField face_voidage_;
    Foam::volScalarField gas_share_;         ///< at the start of the step
    Foam::volScalarField::Internal rate_;    ///< over density [1/s]
    Foam::volVectorField source_;            ///< over density, with what p less p_rgh does [m/s2]
    Foam::surfaceScalarField face_share_;    ///< (eps + Y) / rho, of the volume that feels the pressure gradient
    Foam::surfaceScalarField face_source_;   ///< source through the faces [m3/s2]
    Foam::surfaceScalarField face_mixture_;  ///< eps + M
    Foam::volScalarField following_;         ///< Y
    Foam::volScalarField moving_;            ///< M
    Foam::volScalarField mobility_;          ///< C [m3 s/kg]
    Foam::surfaceScalarField face_mobility_;
    Foam::volVectorField solids_flux_;  ///< A, with what p less p_rgh does [m/s]
    Foam::surfaceVectorField face_directions_;
    Foam::volTensorField::Internal to_cells_;  ///< from sums over faces [1/m2]
    Foam::volScalarField::Internal surplus_;   ///< q - div A [1/s]
    Foam::pimpleControl control_;
    Foam::label reference_cell_ = -1;      ///< of this rank, where no boundary condition gives a pressure
    Foam::scalar reference_pressure_ = 0;  ///< of p_rgh there [Pa]
};

}  // namespace interphase
