// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/gas_properties.hpp"

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "gravityMeshObject.H"

namespace interphase {

using namespace Foam;

namespace {

IOobject constant(const fvMesh& mesh, const char* name, IOobject::readOption read)
{
    return IOobject(name, mesh.time().constant(), mesh, read, IOobject::NO_WRITE);
}

/// Of gravity along its main axis; sign and size as the boundary conditions of OpenFOAM have them that know hRef.
dimensionedScalar along(const vector& g)
{
    return {"along", dimAcceleration, mag(g) > SMALL ? (g & cmptMag(g)) / mag(g) : 0};
}

}  // namespace

double positive_property(const dictionary& dictionary, const char* name)
{
    const double value = dictionary.get<dimensionedScalar>(name).value();
    if (!(value > 0))
        throw UserError(
            std::string(name) + " = " + text(value) + " is not positive",
            std::string(dictionary.name()) + ", line " + std::to_string(dictionary.findEntry(name)->startLineNumber()),
            "give the gas's density rho in kg/m3 and dynamic viscosity mu in Pa s");
    return value;
}

GasTransport::GasTransport(const fvMesh& mesh)
    : IOdictionary(constant(mesh, "transportProperties", IOobject::MUST_READ)),
      mesh_(mesh),
      density_("rho", dimDensity, positive_property(*this, "rho")),
      viscosity_("mu", dimPressure * dimTime, positive_property(*this, "mu"))
{
    const auto line = [this](const char* key) {
        return "constant/transportProperties, line " + std::to_string(findEntry(key)->startLineNumber());
    };
    const auto model = getOrDefault<word>("transportModel", "Newtonian");
    if (model != "Newtonian")
        throw UserError("`transportModel " + model + ";` asks for another viscosity than a constant one",
                        line("transportModel"),
                        "set it to Newtonian or leave it away; rho [kg/m3] and mu [Pa s] are the gas's");
    if (!found("nu")) return;
    const scalar given = get<dimensionedScalar>("nu").value(), meant = (viscosity_ / density_).value();
    if (mag(given - meant) > 1e-3 * meant)  // written with three digits it is meant to be the same
        throw UserError("nu = " + text(given) + " m2/s contradicts mu / rho = " + text(meant) + " m2/s", line("nu"),
                        "leave nu away, or correct one of them");
}

tmp<volScalarField> GasTransport::nu() const
{
    return tmp<volScalarField>::New(
        IOobject("nu", mesh_.time().timeName(), mesh_, IOobject::NO_READ, IOobject::NO_WRITE, false), mesh_,
        viscosity_ / density_);
}

tmp<scalarField> GasTransport::nu(label patch) const
{
    return tmp<scalarField>::New(mesh_.boundary()[patch].size(), (viscosity_ / density_).value());
}

GasProperties::GasProperties(const fvMesh& mesh)
    : transport_(mesh),
      gravity_(meshObjects::gravity::New(mesh.time())),
      reference_height_(constant(mesh, "hRef", IOobject::READ_IF_PRESENT), dimensionedScalar("hRef", dimLength, 0)),
      density_field_(IOobject("rho", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE), mesh,
                     density()),
      height_potential_(IOobject("gh", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE),
                        (gravity_ & mesh.C()) - along(gravity_.value()) * reference_height_)
{}

}  // namespace interphase
