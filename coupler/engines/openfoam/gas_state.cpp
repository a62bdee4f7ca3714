// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/gas_state.hpp"

#include <sstream>
#include <type_traits>

#include "IStringStream.H"
#include "OStringStream.H"

namespace interphase {

using namespace Foam;

namespace {

template <class Type>
void keep_values(Archive& archive, const std::string& name, Field<Type>& values)
{
    static_assert(std::is_same_v<Type, scalar> || std::is_same_v<Type, vector>);
    constexpr std::size_t numbers = sizeof(Type) / sizeof(double);
    archive.keep(name, values.empty() ? nullptr : reinterpret_cast<double*>(values.data()),
                 numbers * static_cast<std::size_t>(values.size()));
}

template <class Type, template <class> class PatchField, class Mesh>
void keep_level(Archive& archive, GeometricField<Type, PatchField, Mesh>& field)
{
    keep_values(archive, "cells", static_cast<Field<Type>&>(field.primitiveFieldRef()));
    auto& boundary = field.boundaryFieldRef(false);
    forAll(boundary, patch)
        keep_values(archive, "patch " + std::to_string(patch), static_cast<Field<Type>&>(boundary[patch]));
}

template <class Type>
std::string written(const fvPatchField<Type>& condition)
{
    OStringStream stream;
    stream.precision(17);  // a double comes back as it was
    stream << condition;
    return stream.str();
}

/// Conditions that the mesh itself makes have nothing but their values.
template <class Type>
void keep_conditions(Archive& archive, GeometricField<Type, fvPatchField, volMesh>& field)
{
    auto& boundary = field.boundaryFieldRef(false);
    forAll(boundary, patch)
    {
        const fvPatch& own = field.mesh().boundary()[patch];
        if (fvPatch::constraintType(own.type())) continue;
        std::string text;
        if (!archive.loads()) text = written(boundary[patch]);
        archive.keep("condition " + std::to_string(patch), text);
        if (!archive.loads()) continue;
        IStringStream stream(text);
        const dictionary dict(stream);
        boundary.set(patch, fvPatchField<Type>::New(own, field.internalField(), dict));
    }
}

template <class Type>
void keep_conditions(Archive&, GeometricField<Type, fvsPatchField, surfaceMesh>&)
{}

template <class FieldOfMesh>
void keep_all(Archive& archive, FieldOfMesh& field)
{
    archive.within(field.name(), [&] {
        label levels = field.nOldTimes(), index = field.timeIndex();
        archive.keep("levels", levels);
        archive.keep("index", index);
        field.timeIndex() = field.time().timeIndex();  // nothing is shifted to the level before while it is read
        keep_conditions(archive, field);
        keep_level(archive, field);
        FieldOfMesh* of = &field;
        for (label level = 1; level <= levels; ++level) {
            of = &of->oldTime();
            archive.within("level " + std::to_string(level), [&] { keep_level(archive, *of); });
        }
        field.timeIndex() = index;
    });
}

/// What OpenFOAM gives nobody to set.
struct OpenTime : Foam::Time {
    static void keep(Archive& archive, Foam::Time& time)
    {
        archive.keep("write_index", time.*(&OpenTime::writeTimeIndex_));
        archive.keep("step", time.*(&OpenTime::deltaT_));
        archive.keep("step_before", time.*(&OpenTime::deltaT0_));
        archive.keep("step_saved", time.*(&OpenTime::deltaTSave_));
    }
};

}  // namespace

void keep_field(Archive& archive, volScalarField& field) { keep_all(archive, field); }
void keep_field(Archive& archive, volVectorField& field) { keep_all(archive, field); }
void keep_field(Archive& archive, surfaceScalarField& field) { keep_all(archive, field); }

void keep_time(Archive& archive, Foam::Time& time)
{
    double now = time.value();
    label index = time.timeIndex();
    archive.keep("now", now);
    archive.keep("index", index);
    if (archive.loads()) time.setTime(now, index);
    OpenTime::keep(archive, time);
}

}  // namespace interphase
