// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/archive.hpp"
#include "fvPatchFields.H"

namespace interphase {

/// The random numbers of a turbulentInlet, which writes all but these: from its first seed on the same fluctuations
/// would come again. Ranks that are others than those that took in begin from a mixture of theirs. Nothing of other
/// conditions.
void keep_random_numbers(Archive& archive, const std::string& name, Foam::fvPatchField<Foam::scalar>& condition);
void keep_random_numbers(Archive& archive, const std::string& name, Foam::fvPatchField<Foam::vector>& condition);

}  // namespace interphase
