// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/pimple_gas.hpp"

#include "adjustPhi.H"
#include "base/user_error.hpp"
#include "constrainHbyA.H"
#include "constrainPressure.H"
#include "engines/openfoam/gas_state.hpp"
#include "engines/openfoam/to_eigen.hpp"
#include "findRefCell.H"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "fixedValueFvPatchFields.H"
#include "fvCFD.H"
#include "wallPolyPatch.H"
#include "zeroGradientFvPatchFields.H"

namespace interphase {

using namespace Foam;

namespace {

template <class Type>
DimensionedField<Type, volMesh> cell_field(const fvMesh& mesh, const char* name, const dimensionSet& dimensions)
{
    return DimensionedField<Type, volMesh>(IOobject(name, mesh.time().timeName(), mesh), mesh,
                                           dimensioned<Type>(name, dimensions, Zero));
}

/// Zero on every boundary that is one.
template <class Type>
GeometricField<Type, fvPatchField, volMesh> field_of_solids(const fvMesh& mesh, const char* name,
                                                            const dimensionSet& dimensions)
{
    return GeometricField<Type, fvPatchField, volMesh>(
        IOobject(name, mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE, false), mesh,
        dimensioned<Type>(name, dimensions, Zero), patch_types(mesh, fixedValueFvPatchField<Type>::typeName));
}

}  // namespace

/// How velocity and flux answer the forces on them: the same in all pressure corrections of a momentum matrix.
struct PimpleGas::Response {
    Response(const fvVectorMatrix& momentum, const surfaceScalarField& share, const surfaceScalarField& mixture,
             const surfaceScalarField& mobility)
        : in_cells("rAU", 1.0 / momentum.A()),
          at_faces("rAUf", fvc::interpolate(in_cells)),
          to_pressure(at_faces * share),
          conductance(mixture * to_pressure + mobility)
    {}

    volScalarField in_cells;      ///< [s]
    surfaceScalarField at_faces;  ///< [s]
    surfaceScalarField to_pressure;
    surfaceScalarField conductance;  ///< of gas and solids together
};

PimpleGas::PimpleGas(fvMesh& mesh)
    : GasFields(mesh),
      face_voidage_("voidagef", fvc::interpolate(voidage_)),
      gas_share_(IOobject("gasShare", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE, false), mesh,
                 dimensionedScalar("one", dimless, 1)),
      rate_(cell_field<scalar>(mesh, "exchangeRate", dimless / dimTime)),
      source_(IOobject("exchangeSource", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE, false),
              mesh, dimensionedVector("none", dimAcceleration, Zero), zeroGradientFvPatchVectorField::typeName),
      face_share_("pressedSharef", face_voidage_ / rho_),
      face_source_("exchangeSourcef", fvc::flux(source_)),
      face_mixture_("mixturef", face_voidage_),
      following_(field_of_solids<scalar>(mesh, "followingSolids", dimless)),
      moving_(field_of_solids<scalar>(mesh, "movingSolids", dimless)),
      mobility_(field_of_solids<scalar>(mesh, "mobilityOfSolids", dimVelocity / (dimPressure / dimLength))),
      face_mobility_("mobilityOfSolidsf", fvc::interpolate(mobility_)),
      solids_flux_(field_of_solids<vector>(mesh, "fluxOfSolids", dimVelocity)),
      face_directions_(mesh.Sf() / mesh.magSf()),
      to_cells_(inv(fvc::surfaceSum(face_directions_ * mesh.Sf())().internalField())),
      surplus_(cell_field<scalar>(mesh, "surplus", dimless / dimTime)),
      control_(mesh)
{
    refuse_control_of_others();
    refuse_other_time_schemes();
    mesh.setFluxRequired(p_rgh_.name());
    if (p_rgh_.needReference()) set_reference_pressure();
}

void PimpleGas::refuse_control_of_others() const
{
    const dictionary& solution = mesh_.solutionDict();
    for (const char* other : {"PISO", "SIMPLE"})
        if (solution.found(other) && !solution.found("PIMPLE"))
            throw UserError(std::string("the solver's control stands in ") + other +
                                ", and this gas is solved by PIMPLE, which would take its defaults",
                            "system/fvSolution, line " + std::to_string(solution.findEntry(other)->startLineNumber()),
                            std::string("rename the block to PIMPLE (nOuterCorrectors 1 is PISO)"));
}

void PimpleGas::refuse_other_time_schemes() const
{
    // take() sets the levels of the gas share that these two look at
    for (const char* term : {"ddt(gasShare,U)", "ddt(U)"}) {
        const std::string scheme = word(mesh_.ddtScheme(term));
        if (scheme != "Euler" && scheme != "backward")
            throw UserError("the time scheme " + scheme + " of " + term +
                                " does not keep the momentum of a gas whose voidage changes",
                            "system/fvSchemes, ddtSchemes", "take Euler, or backward for second order");
    }
}

void PimpleGas::set_reference_pressure()
{
    const dictionary& dict = control_.dict();
    const auto given = [&dict](const word& field) {
        return dict.found(field + "RefCell") || dict.found(field + "RefPoint");
    };
    const bool of_p = given(p_.name()), of_p_rgh = given(p_rgh_.name());
    if (of_p == of_p_rgh)
        throw UserError(
            of_p ? "the pressure has two references, pRefCell or pRefPoint and p_rghRefCell or p_rghRefPoint"
                 : "no boundary condition of p_rgh gives a pressure, and neither does the solver's control",
            "system/fvSolution, PIMPLE",
            of_p ? "leave one of them away"
                 : "add `pRefCell 0; pRefValue 0;` (of p) or `p_rghRefCell 0; p_rghRefValue 0;` [Pa] there, or "
                   "give 0/p_rgh a patch of type fixedValue, prghPressure or the like");
    setRefCell(of_p ? p_ : p_rgh_, p_rgh_, dict, reference_cell_, reference_pressure_);
    if (of_p && reference_cell_ >= 0)
        reference_pressure_ -= rho_.value() * properties_.height_potential()[reference_cell_];
}

void PimpleGas::take(const Demand& demand)
{
    const double density = rho_.value();
    const vector weight = density * g_.value();  // grad p less grad p_rgh
    forAll(rate_, c)
    {
        const auto i = static_cast<std::size_t>(c);
        const auto vector_in = [i](const Scalars& flat) {
            return vector(flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]);
        };
        rate_[c] = demand.rate[i] / density;
        source_[c] = (vector_in(demand.source) - demand.following[i] * weight) / density;
        following_[c] = demand.following[i];
        moving_[c] = demand.moving[i];
        mobility_[c] = demand.mobility[i];
        solids_flux_[c] = vector_in(demand.flux) - demand.mobility[i] * weight;
    }
    // Of the time scheme's levels the current one cancels in solve(); the one before is the start of this step.
    const bool first = gas_share_.nOldTimes() == 0;
    const scalarField at_last_start(gas_share_.primitiveField());
    scalarField& current = gas_share_.primitiveFieldRef();
    forAll(current, c) current[c] = demand.gas_share[static_cast<std::size_t>(c)];
    gas_share_.oldTime().primitiveFieldRef() = current;
    if (!first) gas_share_.oldTime().oldTime().primitiveFieldRef() = at_last_start;

    following_.correctBoundaryConditions();
    moving_.correctBoundaryConditions();
    mobility_.correctBoundaryConditions();
    solids_flux_.correctBoundaryConditions();
    source_.correctBoundaryConditions();
    face_voidage_ = fvc::interpolate(voidage_);
    face_share_ = (face_voidage_ + fvc::interpolate(following_)) / rho_;
    face_mixture_ = face_voidage_ + fvc::interpolate(moving_);
    face_mobility_ = fvc::interpolate(mobility_);
    surplus_ = -fvc::div(fvc::flux(solids_flux_))().internalField();
    forAll(surplus_, c) surplus_[c] += demand.surplus[static_cast<std::size_t>(c)];
    face_source_ = fvc::flux(source_);
    forAll(face_source_.boundaryField(), patch)
    {
        const fvPatchScalarField& pressure = p_rgh_.boundaryField()[patch];
        const bool answers =
            pressure.fixesValue() || pressure.coupled() || isA<fixedFluxPressureFvPatchScalarField>(pressure);
        if (!answers) face_source_.boundaryFieldRef()[patch] = Zero;  // it would go through the boundary
    }
}

void PimpleGas::solve(double, const Demand& demand)
{
    take(demand);
    const surfaceScalarField flux_change(face_voidage_ * fvc::ddtCorr(U_, phi_));  // of old levels only

    while (control_.loop()) {
        superficial_phi_ = face_voidage_ * phi_;
        fvVectorMatrix momentum(fvm::ddt(gas_share_, U_) + fvm::div(superficial_phi_, U_) -
                                fvm::Sp(fvc::ddt(gas_share_) + fvc::div(superficial_phi_), U_) +
                                stress_.divDevReff(U_) + fvm::Sp(rate_, U_));
        momentum.relax();
        if (control_.momentumPredictor())
            Foam::solve(momentum == in_cells(face_source_ - face_share_ * mesh_.magSf() * fvc::snGrad(p_rgh_)));
        const Response response(momentum, face_share_, face_mixture_, face_mobility_);
        while (control_.correct())
            correct_pressure(momentum, response, flux_change);
    }
    superficial_phi_ = face_voidage_ * phi_;
    update_pressure();
}

void PimpleGas::correct_pressure(const fvVectorMatrix& momentum, const Response& response,
                                 const surfaceScalarField& flux_change)
{
    const volVectorField HbyA(constrainHbyA(response.in_cells * momentum.H(), U_, p_rgh_));
    surfaceScalarField phiHbyA("phiHbyA", fvc::flux(HbyA) + response.at_faces * flux_change);
    if (p_rgh_.needReference()) adjustPhi(phiHbyA, U_, p_rgh_);
    phiHbyA += response.at_faces * face_source_;
    constrainPressure(p_rgh_, U_, phiHbyA, response.to_pressure);

    const volScalarField leaving(fvc::div(face_mixture_ * phiHbyA));
    while (control_.correctNonOrthogonal()) {
        fvScalarMatrix pressure(fvm::laplacian(response.conductance, p_rgh_) == leaving.internalField() - surplus_);
        pressure.setReference(reference_cell_, reference_pressure_);
        pressure.solve(mesh_.solver(p_rgh_.select(control_.finalInnerIter())));
        if (!control_.finalNonOrthogonalIter()) continue;
        // All of the correction, also where the pressure takes a part of it only: velocity and flux stay together.
        const surfaceScalarField slope(pressure.flux() / response.conductance);
        phi_ = phiHbyA - response.to_pressure * slope;
        U_ = HbyA;
        U_.ref() += response.in_cells() * in_cells(face_source_ - face_share_ * slope);
        U_.correctBoundaryConditions();
    }
    p_rgh_.relax();
}

tmp<volVectorField::Internal> PimpleGas::in_cells(const surfaceScalarField& force) const
{
    auto mean = tmp<volVectorField::Internal>::New(
        IOobject("forceOnGas", mesh_.time().timeName(), mesh_, IOobject::NO_READ, IOobject::NO_WRITE, false), mesh_,
        dimensionedVector("none", dimAcceleration, Zero));
    vectorField& sums = mean.ref().field();
    const labelUList &owner = mesh_.owner(), &neighbour = mesh_.neighbour();
    const scalarField& along = force.primitiveField();
    const vectorField& directions = face_directions_.primitiveField();
    forAll(neighbour, face)
    {
        const vector push = along[face] * directions[face];
        sums[owner[face]] += push;
        sums[neighbour[face]] += push;
    }
    forAll(mesh_.boundary(), patch)
    {
        const labelUList& cells = mesh_.boundary()[patch].faceCells();
        const scalarField& along_patch = force.boundaryField()[patch];
        const vectorField& patch_directions = face_directions_.boundaryField()[patch];
        forAll(cells, face) sums[cells[face]] += along_patch[face] * patch_directions[face];
    }
    const tensorField& to_cells = to_cells_.field();
    forAll(sums, c) sums[c] = to_cells[c] & sums[c];
    return mean;
}

Scalars PimpleGas::outflow() const
{
    const scalarField rate(fvc::surfaceIntegrate(superficial_phi_)().primitiveField());
    const double dt = mesh_.time().deltaTValue();
    Scalars volume(static_cast<std::size_t>(rate.size()));
    forAll(rate, c) volume[static_cast<std::size_t>(c)] = dt * rate[c] * mesh_.V()[c];
    return volume;
}

Crossing PimpleGas::crossing() const
{
    Crossing total;
    forAll(phi_.boundaryField(), patch)
    {
        if (mesh_.boundary()[patch].coupled()) continue;
        for (const scalar out : superficial_phi_.boundaryField()[patch])
            (out > 0 ? total.out : total.in) += std::abs(out);
    }
    const double dt = mesh_.time().deltaTValue();
    return {dt * total.in, dt * total.out};
}

std::vector<OpenFace> PimpleGas::open_faces() const
{
    std::vector<OpenFace> all;
    forAll(mesh_.boundary(), patch)
    {
        const polyPatch& shape = mesh_.boundaryMesh()[patch];
        if (shape.coupled() || isA<wallPolyPatch>(shape) || polyPatch::constraintType(shape.type())) continue;
        const vectorField normals(mesh_.boundary()[patch].nf());
        forAll(normals, face) all.push_back({static_cast<int>(shape.faceCells()[face]), to_eigen(normals[face])});
    }
    return all;
}

void PimpleGas::keep_fields(GasState& state)
{
    GasFields::keep_fields(state);
    state.keep(gas_share_);
}

double PimpleGas::courant_number() const
{
    const scalarField outflow(fvc::surfaceSum(mag(phi_))().primitiveField());
    return 0.5 * gMax(scalarField(outflow / mesh_.V().field())) * mesh_.time().deltaTValue();
}

}  // namespace interphase
