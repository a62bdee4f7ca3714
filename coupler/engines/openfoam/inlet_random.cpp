// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/inlet_random.hpp"

#include <cstdint>

#include "engines/openfoam/private_member.hpp"
#include "fvMesh.H"
#include "turbulentInletFvPatchField.H"
#include "volFields.H"

namespace interphase {

struct RandomGenerator {
    using Member = Foam::Rand48 Foam::Random::*;
    friend Member place_of(RandomGenerator);
};
struct RandomOfScalarInlet {
    using Member = Foam::Random Foam::turbulentInletFvPatchField<Foam::scalar>::*;
    friend Member place_of(RandomOfScalarInlet);
};
struct RandomOfVectorInlet {
    using Member = Foam::Random Foam::turbulentInletFvPatchField<Foam::vector>::*;
    friend Member place_of(RandomOfVectorInlet);
};
template struct PrivateMember<RandomGenerator, &Foam::Random::generator_>;
template struct PrivateMember<RandomOfScalarInlet, &Foam::turbulentInletFvPatchField<Foam::scalar>::ranGen_>;
template struct PrivateMember<RandomOfVectorInlet, &Foam::turbulentInletFvPatchField<Foam::vector>::ranGen_>;

namespace {

using Foam::scalar, Foam::vector, Foam::turbulentInletFvPatchField;

void keep(Archive& archive, const std::string& name, Foam::Random& random)
{
    Foam::Rand48& generator = random.*place_of(RandomGenerator{});
    static_assert(sizeof generator == sizeof(std::uint64_t));
    if (!archive.loads() || archive.same_ranks()) return archive.keep(name, generator);
    std::uint64_t mixed = 0;
    for (int n = 0; n < archive.parts(); ++n)
        for (const std::uint64_t of_part : archive.part_as<std::uint64_t>(n, name))
            mixed = 3 * mixed + of_part;
    generator.seed(static_cast<std::uint32_t>(mixed >> 16));  // the lower ones repeat soonest
}

}  // namespace

void keep_random_numbers(Archive& archive, const std::string& name, Foam::fvPatchField<scalar>& condition)
{
    auto* inlet = dynamic_cast<turbulentInletFvPatchField<scalar>*>(&condition);
    if (inlet) keep(archive, name, inlet->*place_of(RandomOfScalarInlet{}));
}

void keep_random_numbers(Archive& archive, const std::string& name, Foam::fvPatchField<vector>& condition)
{
    auto* inlet = dynamic_cast<turbulentInletFvPatchField<vector>*>(&condition);
    if (inlet) keep(archive, name, inlet->*place_of(RandomOfVectorInlet{}));
}

}  // namespace interphase
