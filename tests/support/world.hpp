// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/communicator.hpp"

namespace interphase::test {

/// All ranks of a test.
inline const Communicator& world()
{
    static const Communicator comm;
    return comm;
}

/// This rank by itself.
inline const Communicator& alone()
{
    static const Communicator comm(MPI_COMM_SELF);
    return comm;
}

}  // namespace interphase::test
