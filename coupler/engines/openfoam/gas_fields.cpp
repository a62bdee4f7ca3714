// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/gas_fields.hpp"

#include <cmath>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "engines/openfoam/fields_of_others.hpp"
#include "engines/openfoam/gas_state.hpp"
#include "engines/openfoam/to_eigen.hpp"
#include "fixedValueFvPatchFields.H"
#include "fvcFlux.H"
#include "fvcGrad.H"
#include "fvcSnGrad.H"
#include "fvcSurfaceIntegrate.H"
#include "surfaceFields.H"
#include "surfaceInterpolate.H"
#include "zeroGradientFvPatchFields.H"

namespace interphase {

using namespace Foam;

namespace {

Scalars flat(const volVectorField& field)
{
    Scalars numbers(3 * static_cast<std::size_t>(field.size()));
    forAll(field, c) for (direction axis = 0; axis < 3; ++axis) numbers[3 * static_cast<std::size_t>(c) + axis] =
        field[c][axis];
    return numbers;
}

/// Where the velocity is given, the inflow carries no particles and the velocity is superficial: voidage 1.
wordList voidage_patch_types(const volVectorField& U)
{
    wordList types = patch_types(U.mesh(), zeroGradientFvPatchScalarField::typeName);
    forAll(types, patch)
    {
        const auto& field = U.boundaryField()[patch];
        const word& own = field.patch().type();
        if (!fvPatch::constraintType(own) && field.fixesValue() && own != "wall")
            types[patch] = fixedValueFvPatchScalarField::typeName;
    }
    return types;
}

IOobject in_time(const fvMesh& mesh, const char* name, IOobject::readOption read)
{
    return IOobject(name, mesh.time().timeName(), mesh, read, IOobject::AUTO_WRITE);
}

}  // namespace

wordList patch_types(const fvMesh& mesh, const word& type)
{
    wordList types(mesh.boundary().size(), type);
    forAll(types, patch)
    {
        const word& own = mesh.boundary()[patch].type();
        if (fvPatch::constraintType(own)) types[patch] = own;
    }
    return types;
}

GasFields::GasFields(fvMesh& mesh)
    : mesh_(mesh),
      part_(mesh),
      addressing_(mesh),
      properties_(mesh),
      g_(properties_.gravity()),
      rho_(properties_.density()),
      mu_(properties_.viscosity()),
      U_(in_time(mesh, "U", IOobject::MUST_READ), mesh),
      p_rgh_(in_time(mesh, "p_rgh", IOobject::MUST_READ), mesh),
      voidage_(in_time(mesh, "voidage", IOobject::NO_READ), mesh, dimensionedScalar("one", dimless, 1),
               voidage_patch_types(U_)),
      p_(in_time(mesh, "p", IOobject::NO_READ), p_rgh_ + rho_ * properties_.height_potential()),
      phi_(in_time(mesh, "phi", IOobject::READ_IF_PRESENT), fvc::flux(U_)),
      superficial_phi_("voidagePhi", fvc::interpolate(voidage_) * phi_),
      stress_(properties_.transport(), voidage_, U_, superficial_phi_, phi_)
{
    if (p_rgh_.dimensions() != dimPressure)
        throw UserError("p_rgh has other dimensions than a pressure", std::string(p_rgh_.objectPath()),
                        "give it in Pa: dimensions [1 -1 -2 0 0 0 0]");

    // A flux that was read may be of a run with another inlet
    forAll(phi_.boundaryField(), patch)
    {
        if (U_.boundaryField()[patch].fixesValue())
            phi_.boundaryFieldRef()[patch] == (U_.boundaryField()[patch] & mesh.boundary()[patch].Sf());
    }
    superficial_phi_ = fvc::interpolate(voidage_) * phi_;
}

void GasFields::set_voidage(const Scalars& voidage)
{
    forAll(voidage_, c) voidage_[c] = voidage[static_cast<std::size_t>(c)];
    voidage_.correctBoundaryConditions();
}

Scalars GasFields::velocity() const { return flat(U_); }

Scalars GasFields::pressure_gradient() const
{
    const tmp<volVectorField> gradient = fvc::grad(p_rgh_);
    const vector hydrostatic = rho_.value() * g_.value();
    Scalars numbers = flat(gradient());
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] += hydrostatic[static_cast<direction>(i % 3)];
    return numbers;
}

Scalars GasFields::velocity_gradient() const
{
    const tmp<volTensorField> gradient = fvc::grad(U_);
    Scalars numbers(9 * static_cast<std::size_t>(U_.size()));
    forAll(U_, c)
    {
        for (direction entry = 0; entry < 9; ++entry)
            numbers[9 * static_cast<std::size_t>(c) + entry] = gradient()[c][entry];
    }
    return numbers;
}

Scalars GasFields::viscous_force() const
{
    // summed over faces, with the schemes that every case has
    const tmp<volTensorField> of_transpose = dev2(T(fvc::grad(U_)));
    const surfaceVectorField traction(mesh_.magSf() * fvc::snGrad(U_) + (mesh_.Sf() & fvc::interpolate(of_transpose)));
    Scalars numbers = flat(fvc::surfaceIntegrate(traction)());
    for (double& number : numbers)
        number *= mu_.value();
    return numbers;
}

Scalars GasFields::gradient(const Scalars& of_cells) const
{
    volScalarField field(
        IOobject("ofSolids", mesh_.time().timeName(), mesh_, IOobject::NO_READ, IOobject::NO_WRITE, false), mesh_,
        dimensionedScalar("zero", dimless, 0), zeroGradientFvPatchScalarField::typeName);
    forAll(field, c) field[c] = of_cells[static_cast<std::size_t>(c)];
    field.correctBoundaryConditions();
    return flat(fvc::grad(field)());
}

Scalars GasFields::stretching(const Scalars& flow) const
{
    volVectorField field(
        IOobject("flowOfSolids", mesh_.time().timeName(), mesh_, IOobject::NO_READ, IOobject::NO_WRITE, false), mesh_,
        dimensionedVector("zero", dimless, Zero), patch_types(mesh_, fixedValueFvPatchVectorField::typeName));
    forAll(field, c) for (direction axis = 0; axis < 3; ++axis) field[c][axis] =
        flow[3 * static_cast<std::size_t>(c) + axis];
    field.correctBoundaryConditions();
    const tmp<volTensorField> gradient = fvc::grad(field);
    Scalars numbers(flow.size());
    forAll(field, c) for (direction axis = 0; axis < 3; ++axis) numbers[3 * static_cast<std::size_t>(c) + axis] =
        gradient()[c][4 * axis];  // the diagonal
    return numbers;
}

void GasFields::write_along(const std::vector<CellField>& fields) { set_in_registry(mesh_, fields); }

std::optional<Problem> GasFields::trouble() const
{
    forAll(U_, c)
    {
        if (std::isfinite(magSqr(U_[c])) && std::isfinite(p_rgh_[c])) continue;
        return Problem{"the gas field " + std::string(std::isfinite(p_rgh_[c]) ? "U" : "p_rgh") +
                           " is not finite in cell " + std::to_string(c) + " of rank " +
                           std::to_string(UPstream::myProcNo()),
                       "at " + text(part_.view().centre[static_cast<std::size_t>(c)]),
                       "reduce deltaT (or maxCo) in system/controlDict; look at the last written fields"};
    }
    return std::nullopt;
}

double GasFields::pressure_at(const Vector& point) const
{
    const CellAddress address = part_.search(point);
    double sums[2] = {address.known() ? p_[address.cell] : 0.0, address.known() ? 1.0 : 0.0};
    reduce(sums[0], sumOp<scalar>());
    reduce(sums[1], sumOp<scalar>());
    if (sums[1] == 0)
        throw UserError("the pressure tap " + text(point) + " m is in no cell of the mesh, which lies between " +
                            text(Vector(bounds().col(0))) + " and " + text(Vector(bounds().col(1))) + " m",
                        "records/pressureTaps in system/couplingDict",
                        "give two points inside the mesh, or none: then no pressure drop is recorded");
    return sums[0] / sums[1];
}

double GasFields::total_volume() const { return gSum(mesh_.V()); }

Box GasFields::bounds() const
{
    const boundBox& all = mesh_.bounds();
    Box box;
    box.col(0) = to_eigen(all.min());
    box.col(1) = to_eigen(all.max());
    return box;
}

Vector GasFields::gravity() const { return {g_.value().x(), g_.value().y(), g_.value().z()}; }

void GasFields::keep(Archive& archive)
{
    GasState state(archive, mesh_, addressing_);
    keep_fields(state);
}

void GasFields::keep_fields(GasState& state)
{
    // conditions look at the fluxes when they are made anew
    state.keep(phi_);
    state.keep(superficial_phi_);
    state.keep(voidage_);
    state.keep(U_);
    state.keep(p_rgh_);
    state.keep(p_);
}

void GasFields::update_pressure() { p_ == p_rgh_ + rho_* properties_.height_potential(); }

}  // namespace interphase
