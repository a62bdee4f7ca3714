// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/inlet_random.hpp"

#include <cstdint>

#include "fvMesh.H"
#include "turbulentInletFvPatchField.H"
#include "volFields.H"

namespace interphase {

namespace {

using Foam::scalar, Foam::vector, Foam::turbulentInletFvPatchField;

/// An explicit instantiation may name a private member.
template <class Name, typename Name::Member member>
struct Opened {
    friend typename Name::Member place_of(Name) { return member; }
};
struct Generator {
    using Member = Foam::Rand48 Foam::Random::*;
    friend Member place_of(Generator);
};
struct OfScalar {
    using Member = Foam::Random turbulentInletFvPatchField<scalar>::*;
    friend Member place_of(OfScalar);
};
struct OfVector {
    using Member = Foam::Random turbulentInletFvPatchField<vector>::*;
    friend Member place_of(OfVector);
};
template struct Opened<Generator, &Foam::Random::generator_>;
template struct Opened<OfScalar, &turbulentInletFvPatchField<scalar>::ranGen_>;
template struct Opened<OfVector, &turbulentInletFvPatchField<vector>::ranGen_>;

void keep(Archive& archive, const std::string& name, Foam::Random& random)
{
    Foam::Rand48& generator = random.*place_of(Generator{});
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
    if (inlet) keep(archive, name, inlet->*place_of(OfScalar{}));
}

void keep_random_numbers(Archive& archive, const std::string& name, Foam::fvPatchField<vector>& condition)
{
    auto* inlet = dynamic_cast<turbulentInletFvPatchField<vector>*>(&condition);
    if (inlet) keep(archive, name, inlet->*place_of(OfVector{}));
}

}  // namespace interphase
