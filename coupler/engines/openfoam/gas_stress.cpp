// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/gas_stress.hpp"

#include "fvCFD.H"

namespace interphase {

using namespace Foam;

namespace {

const geometricOneField unity;  // the model keeps a reference

template <class Type>
tmp<GeometricField<Type, fvPatchField, volMesh>> uniform(const fvMesh& mesh, const char* name,
                                                         const dimensioned<Type>& value)
{
    return tmp<GeometricField<Type, fvPatchField, volMesh>>::New(
        IOobject(name, mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE, false), mesh, value);
}

}  // namespace

// OpenFOAM reads a dictionary of the model's name on the way; a case need have none of turbulence, but it has this one.
GasStress::GasStress(const GasTransport& transport, const volScalarField& voidage, const volVectorField& U,
                     const surfaceScalarField& superficial_phi, const surfaceScalarField& phi)
    : incompressible::turbulenceModel("laminar", unity, unity, U, superficial_phi, phi, transport,
                                      "transportProperties"),
      nu_("nu", transport.viscosity() / transport.density()),
      voidage_(voidage)
{
    rename(propertiesName);
}

tmp<volSymmTensorField> GasStress::devReff() const { return -voidage_ * nu_ * dev(twoSymm(fvc::grad(U_))); }

tmp<fvVectorMatrix> GasStress::divDevReff(volVectorField& U) const
{
    const volScalarField voidage_nu("voidageNu", voidage_ * nu_);
    return -fvm::laplacian(voidage_nu, U) - fvc::div(voidage_nu * dev2(T(fvc::grad(U))));
}

tmp<volScalarField> GasStress::nut() const { return uniform(mesh_, "nut", dimensionedScalar("nut", dimViscosity, 0)); }

tmp<scalarField> GasStress::nut(label patch) const
{
    return tmp<scalarField>::New(mesh_.boundary()[patch].size(), 0.0);
}

tmp<volScalarField> GasStress::k() const { return uniform(mesh_, "k", dimensionedScalar("k", sqr(dimVelocity), 0)); }

tmp<volScalarField> GasStress::epsilon() const
{
    return uniform(mesh_, "epsilon", dimensionedScalar("epsilon", sqr(dimVelocity) / dimTime, 0));
}

tmp<volSymmTensorField> GasStress::R() const
{
    return uniform(mesh_, "R", dimensionedSymmTensor("R", sqr(dimVelocity), Zero));
}

}  // namespace interphase
