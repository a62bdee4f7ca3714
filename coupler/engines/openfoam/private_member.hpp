// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase {

/// The way to a private member of OpenFOAM that has no access function: an explicit instantiation may name it. `Name`
/// is a struct of the file that needs it, with the member's type and a friend that the instantiation defines:
///
///     struct Index { using Member = Foam::label Foam::timeControl::*; friend Member place_of(Index); };
///     template struct PrivateMember<Index, &Foam::timeControl::executionIndex_>;
///     control.*place_of(Index{}) = 0;
template <class Name, typename Name::Member member>
struct PrivateMember {
    friend typename Name::Member place_of(Name) { return member; }
};

}  // namespace interphase
