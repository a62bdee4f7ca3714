// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vector.hpp"
#include "vector.H"

namespace interphase {

/// A vector or point of OpenFOAM as one of ours.
inline Vector to_eigen(const Foam::vector& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace interphase
