// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/patch_conditions.hpp"

#include <map>

#include "base/user_error.hpp"
#include "engines/openfoam/foam_errors.hpp"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "volFields.H"

namespace interphase {

namespace {

struct Unfit {
    const char* why;
    const char* instead;
};

const Unfit compressible{"is for a compressible gas, and this one has no sound and no temperature",
                         "`advective`, fixedValue or totalPressure where the gas leaves or enters"};
const Unfit hydrostatic{"gives a pressure with the column's weight, and p_rgh is without it",
                        "`prghPressure` with p (or a fixed p_rgh, uniform over a column at rest)"};
const Unfit several_phases{"is for a free surface between two fluids, and there is one gas", "`prghPressure`"};

const std::map<std::string, Unfit> unfit_for_pressure{
    {"waveTransmissive", compressible},
    {"syringePressure", compressible},
    {"plenumPressure", compressible},
    {"uniformDensityHydrostaticPressure", hydrostatic},
    {"phaseHydrostaticPressure", several_phases},
    {"waveSurfacePressure", several_phases},
    {"prghTotalHydrostaticPressure",
     {"starts from a hydrostatic field ph_rgh of a gas whose density varies", "`prghTotalPressure`"}},
};

const std::map<std::string, Unfit> unfit_for_velocity{
    {"waveTransmissive", {compressible.why, "`advective`, or inletOutlet"}},
    {"supersonicFreestream", {compressible.why, "`freestreamVelocity`"}},
    {"variableHeightFlowRateInletVelocity", {several_phases.why, "`flowRateInletVelocity`"}},
    {"outletPhaseMeanVelocity", {several_phases.why, "`flowRateOutletVelocity`"}},
};

template <class Field>
void refuse_unfit(const Foam::fvMesh& mesh, const char* name, const std::map<std::string, Unfit>& unfit)
{
    const auto* field = mesh.findObject<Field>(name);
    if (!field) return;
    for (const auto& patch : field->boundaryField())
        if (const auto found = unfit.find(patch.type()); found != unfit.end())
            throw UserError("the boundary condition `" + found->first + "` " + found->second.why,
                            std::string(field->objectPath()) + ", patch `" + patch.patch().name() + "`",
                            std::string("take ") + found->second.instead);
}

template <class Field>
std::string failing(const Foam::fvMesh& mesh, const char* name, const std::string& message)
{
    auto* field = mesh.getObjectPtr<Field>(name);
    if (!field) return "";
    for (auto& patch : field->boundaryFieldRef(false)) {
        // the pressure equation sets its gradient first; alone it fails in another way
        if (Foam::isA<Foam::fixedFluxPressureFvPatchScalarField>(patch)) continue;
        try {
            patch.updateCoeffs();
        } catch (const Foam::error& error) {
            if (same_complaint(error.message(), message))
                return std::string(field->objectPath()) + ", patch `" + patch.patch().name() + "`, type " +
                       patch.type();
        }
    }
    return "";
}

}  // namespace

void refuse_unfit_conditions(const Foam::fvMesh& mesh)
{
    refuse_unfit<Foam::volScalarField>(mesh, "p_rgh", unfit_for_pressure);
    refuse_unfit<Foam::volVectorField>(mesh, "U", unfit_for_velocity);
}

std::vector<std::string> conditions_not_kept(const Foam::fvMesh& mesh)
{
    std::vector<std::string> found;
    const auto* velocity = mesh.findObject<Foam::volVectorField>("U");
    if (!velocity) return found;
    for (const auto& patch : velocity->boundaryField())
        for (const char* type : {"turbulentDFSEMInlet", "turbulentDigitalFilterInlet"})
            if (patch.type() == type) found.push_back(std::string(type) + " of patch " + patch.patch().name());
    return found;
}

std::string failing_condition(const Foam::fvMesh& mesh, const std::string& message)
{
    if (!asks_for_what_is_not_there(message)) return "";
    const std::string of_velocity = failing<Foam::volVectorField>(mesh, "U", message);
    return of_velocity.empty() ? failing<Foam::volScalarField>(mesh, "p_rgh", message) : of_velocity;
}

}  // namespace interphase
