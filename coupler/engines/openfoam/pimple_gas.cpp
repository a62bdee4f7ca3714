// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/pimple_gas.hpp"

#include "adjustPhi.H"
#include "constrainHbyA.H"
#include "constrainPressure.H"
#include "findRefCell.H"
#include "fvCFD.H"

namespace interphase {

using namespace Foam;

namespace {

template <class Type>
DimensionedField<Type, volMesh> cell_field(const fvMesh& mesh, const char* name, const dimensionSet& dimensions)
{
    return DimensionedField<Type, volMesh>(IOobject(name, mesh.time().timeName(), mesh), mesh,
                                           dimensioned<Type>(name, dimensions, Zero));
}

}  // namespace

PimpleGas::PimpleGas(fvMesh& mesh)
    : GasFields(mesh),
      phi_(IOobject("phi", mesh.time().timeName(), mesh, IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE),
           fvc::flux(U_)),
      rate_(cell_field<scalar>(mesh, "exchangeRate", dimless / dimTime)),
      source_(cell_field<vector>(mesh, "exchangeSource", dimAcceleration)),
      control_(mesh)
{
    mesh.setFluxRequired(p_rgh_.name());
    setRefCell(p_rgh_, control_.dict(), reference_cell_, reference_pressure_);
}

void PimpleGas::solve(double, const Scalars& rate, const Scalars& source)
{
    const double per_density = 1.0 / rho_.value();
    forAll(rate_, c)
    {
        const auto i = static_cast<std::size_t>(c);
        rate_[c] = rate[i] * per_density;
        source_[c] = vector(source[3 * i], source[3 * i + 1], source[3 * i + 2]) * per_density;
    }
    const dimensionedScalar nu("nu", mu_ / rho_);
    const surfaceScalarField face_voidage("voidagef", fvc::interpolate(voidage_));
    const volScalarField voidage_rate(fvc::ddt(voidage_));
    const volScalarField voidage_nu("voidageNu", voidage_ * nu);

    while (control_.loop()) {
        const surfaceScalarField voidage_phi("voidagePhi", face_voidage * phi_);
        fvVectorMatrix momentum(fvm::ddt(voidage_, U_) + fvm::div(voidage_phi, U_) -
                                    fvm::Sp(voidage_rate + fvc::div(voidage_phi), U_) - fvm::laplacian(voidage_nu, U_) -
                                    fvc::div(voidage_nu * dev2(T(fvc::grad(U_)))) + fvm::Sp(rate_, U_) ==
                                source_);
        momentum.relax();
        if (control_.momentumPredictor()) Foam::solve(momentum == -voidage_ * fvc::grad(p_rgh_) / rho_);
        while (control_.correct())
            correct_pressure(momentum, voidage_rate, face_voidage);
    }
    update_pressure();
}

void PimpleGas::correct_pressure(fvVectorMatrix& momentum, const volScalarField& voidage_rate,
                                 const surfaceScalarField& face_voidage)
{
    const volScalarField rAU("rAU", 1.0 / momentum.A());
    const volScalarField pressure_response(rAU * voidage_ / rho_);
    const surfaceScalarField face_response("rAUf", fvc::interpolate(pressure_response));

    const volVectorField HbyA(constrainHbyA(rAU * momentum.H(), U_, p_rgh_));
    surfaceScalarField phiHbyA("phiHbyA",
                               fvc::flux(HbyA) + face_voidage * fvc::interpolate(rAU) * fvc::ddtCorr(U_, phi_));
    if (p_rgh_.needReference()) adjustPhi(phiHbyA, U_, p_rgh_);
    constrainPressure(p_rgh_, U_, phiHbyA, face_response);

    while (control_.correctNonOrthogonal()) {
        fvScalarMatrix pressure(fvm::laplacian(face_voidage * face_response, p_rgh_) ==
                                voidage_rate + fvc::div(face_voidage * phiHbyA));
        pressure.setReference(reference_cell_, reference_pressure_);
        pressure.solve(mesh_.solver(p_rgh_.select(control_.finalInnerIter())));
        if (control_.finalNonOrthogonalIter()) phi_ = phiHbyA - pressure.flux() / face_voidage;
    }
    p_rgh_.relax();
    U_ = HbyA - pressure_response * fvc::grad(p_rgh_);
    U_.correctBoundaryConditions();
}

double PimpleGas::courant_number() const
{
    const scalarField outflow(fvc::surfaceSum(mag(phi_))().primitiveField());
    return 0.5 * gMax(scalarField(outflow / mesh_.V().field())) * mesh_.time().deltaTValue();
}

}  // namespace interphase
