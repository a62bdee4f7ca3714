// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/fields_of_others.hpp"

#include <algorithm>

#include "engines/openfoam/gas_fields.hpp"
#include "volFields.H"
#include "zeroGradientFvPatchFields.H"

namespace interphase {

using namespace Foam;

namespace {

template <class Type>
void set_one(const fvMesh& mesh, const CellField& given)
{
    using Field = GeometricField<Type, fvPatchField, volMesh>;
    const dimensionSet unit(0, given.velocities, -given.velocities, 0, 0);
    auto* field = mesh.getObjectPtr<Field>(given.name);
    if (!field) {
        field = new Field(IOobject(given.name, mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::AUTO_WRITE),
                          mesh, dimensioned<Type>(given.name, unit, Zero),
                          patch_types(mesh, zeroGradientFvPatchField<Type>::typeName));
        field->store();  // the registry's from now on
    }
    std::copy(given.values.begin(), given.values.end(), reinterpret_cast<double*>(field->primitiveFieldRef().data()));
    field->correctBoundaryConditions();
}

}  // namespace

void set_in_registry(const fvMesh& mesh, const std::vector<CellField>& fields)
{
    for (const CellField& field : fields)
        if (field.vector)
            set_one<vector>(mesh, field);
        else
            set_one<scalar>(mesh, field);
}

}  // namespace interphase
