// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "modify.h"

namespace interphase {

using FixCreator = LAMMPS_NS::Fix* (*)(LAMMPS_NS::LAMMPS*, int, char**);
using FixMap = std::map<std::string, FixCreator>;

namespace detail {

// LIGGGHTS has no call to add a fix style to a running program, and its table of styles is private. An explicit
// instantiation may name a private member, so this reaches the table of the unmodified library.
template <FixMap* LAMMPS_NS::Modify::*Member>
struct FixMapAccess {
    friend FixMap* fix_map_of(LAMMPS_NS::Modify& modify) { return modify.*Member; }
};

FixMap* fix_map_of(LAMMPS_NS::Modify& modify);
template struct FixMapAccess<&LAMMPS_NS::Modify::fix_map>;

}  // namespace detail

inline bool knows_fix_style(LAMMPS_NS::Modify& modify, const std::string& name)
{
    return detail::fix_map_of(modify)->count(name) > 0;
}

/// Makes a fix style known to this LIGGGHTS. Returns false where the name is taken.
inline bool register_fix_style(LAMMPS_NS::Modify& modify, const std::string& name, FixCreator create)
{
    return detail::fix_map_of(modify)->emplace(name, create).second;
}

}  // namespace interphase
