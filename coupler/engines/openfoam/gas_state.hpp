// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Time.H"
#include "base/archive.hpp"
#include "surfaceFields.H"
#include "volFields.H"

namespace interphase {

/// A field as it is on this rank: values in cells (faces) and on boundaries, those of the steps before that a time
/// scheme looks at, and what boundary conditions have beside their values (a gradient, a reference), as they write it
/// into a case's files.
void keep_field(Archive& archive, Foam::volScalarField& field);
void keep_field(Archive& archive, Foam::volVectorField& field);
void keep_field(Archive& archive, Foam::surfaceScalarField& field);

/// The clock: time, number and length of the steps, and what was written last.
void keep_time(Archive& archive, Foam::Time& time);

}  // namespace interphase
