// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "step/messages.hpp"

namespace interphase {

/// The particles whose owner cells this rank has [n], with what they brought: the optional messages are empty where
/// nobody asked for them.
struct Visitors {
    std::vector<int> cell;  ///< of this rank
    std::vector<Visitor> visitor;
    std::vector<Owed> owed;
    std::vector<Restraint> restraint;
    std::vector<Momentum> momentum;

    std::size_t size() const { return cell.size(); }
};

}  // namespace interphase
