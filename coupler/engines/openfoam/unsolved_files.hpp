// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fileName.H"

namespace interphase {

/// A UserError for a file of the case in `folder` that a solver of OpenFOAM would act on and this gas does not, so that
/// nothing is passed over in silence. Files that ask for nothing (laminar, inactive, static) are let be. One rank's
/// look is enough; all may take it.
void refuse_what_is_not_solved(const Foam::fileName& folder);

}  // namespace interphase
