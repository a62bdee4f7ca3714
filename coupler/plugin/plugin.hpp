// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All that a plug-in includes. A plug-in is a shared library with fix styles for LIGGGHTS; one line makes it one:
///
///     INTERPHASE_PLUGIN("bouncy", {"bouncy/spheres", &interphase::create<FixBouncySpheres>})
///
/// `interphase` (entry `plugins` of system/couplingDict) and `interphase-liggghts` (option -plugin) load it into the
/// unmodified LIGGGHTS, whose scripts then know the styles. plugins/README.md tells the rest.

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <type_traits>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "neigh_list.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "plugin/counter.hpp"
#include "plugin/fingerprint.hpp"
#include "plugin/method.hpp"
#include "plugin/solid_stress.hpp"
#include "plugin/wall_gaps.hpp"
#include "pointers.h"
#include "update.h"

namespace interphase {

/// Changes whenever a plug-in built before could be misread or misused.
constexpr std::uint32_t plugin_interface_version = 5;

/// A fix style that the plug-in brings: as a script writes it, and what makes one.
struct PluginStyle {
    const char* name;
    LAMMPS_NS::Fix* (*create)(LAMMPS_NS::LAMMPS*, int, char**);
};

/// One thing that a plug-in and the program that loads it must have been built against alike: a text, or (text null) a
/// number.
struct BuildFact {
    const char* what;
    const char* text;
    std::int64_t number;
};

/// What a plug-in says of itself. The version stands first for ever; what follows it is laid out as that version says.
struct PluginDescriptor {
    std::uint32_t interface_version;
    std::uint32_t fact_count;
    const BuildFact* facts;
    const char* name;
    std::uint64_t style_count;
    const PluginStyle* styles;
};
static_assert(std::is_standard_layout_v<PluginDescriptor> && std::is_trivial_v<PluginDescriptor>);

/// The C function that every plug-in has: returns its PluginDescriptor.
constexpr const char* plugin_entry_point = "interphase_plugin";
using PluginEntryPoint = const PluginDescriptor* (*)();

/// What else a plug-in may bring: a list, by a C function of its own.
template <class Item>
struct PluginList {
    std::uint64_t count;
    const Item* items;
};
constexpr const char* plugin_methods_entry_point = "interphase_plugin_methods";
using PluginMethodsEntryPoint = const PluginList<PluginMethod>* (*)();
constexpr const char* plugin_counters_entry_point = "interphase_plugin_counters";
using PluginCountersEntryPoint = const PluginList<Counter>* (*)();

// --- what a fix of a plug-in may tell the coupler, by LIGGGHTS's own Fix::extract(name, dimension)
// -----------------------

/// double*: the longest solid step [s] that the fix bears with the particles there are; asked for after the script. The
/// coupler keeps to it where it chooses the step, and refuses a longer one that is given.
constexpr const char* extract_solid_step_limit = "solid_step_limit";

/// SolidStress* (exactly that type, as void*): what the fix wants to know of the solids' stress on the gas mesh, see
/// plugin/solid_stress.hpp. At most one fix asks for it. It lives as long as the fix.
constexpr const char* extract_solid_stress = "solid_stress";

/// int*: not 0 where the fix, in gas steps of one solid step, wants to begin with the forces of the new gas, so that
/// its particles move by them in the same step. They are velocity Verlet's, and `f` and `v` may be set anew between
/// steps.
constexpr const char* extract_takes_new_forces = "takes_new_forces";

/// int*: not 0 where the fix moves particles at the start of a step with the velocity that they have, and lets forces
/// change it afterwards. Without a word the coupler takes it that they move after half a kick by the last step's
/// forces, as LIGGGHTS's own integrators do it. It predicts from that how far the solids move in a gas step.
constexpr const char* extract_moves_before_forces = "moves_before_forces";

/// CounterValues*: of the plug-in's counters, all of them (plugin/counter.hpp). Asked for now and then, at no cost
/// between.
constexpr const char* extract_counters = "counters";

// --- what the macro below is made of
// ------------------------------------------------------------------------------------

#define INTERPHASE_QUOTED(x) #x
#define INTERPHASE_VALUE(x) INTERPHASE_QUOTED(x)

#if defined(__clang__)
#define INTERPHASE_COMPILER "Clang " INTERPHASE_VALUE(__clang_major__)
#elif defined(__INTEL_COMPILER)
#define INTERPHASE_COMPILER "Intel " INTERPHASE_VALUE(__INTEL_COMPILER)
#elif defined(__GNUC__)
#define INTERPHASE_COMPILER "GCC " INTERPHASE_VALUE(__GNUC__)
#else
#define INTERPHASE_COMPILER "unknown"
#endif

#if defined(OPEN_MPI)
#define INTERPHASE_MPI "Open MPI " INTERPHASE_VALUE(OMPI_MAJOR_VERSION) "." INTERPHASE_VALUE(OMPI_MINOR_VERSION)
#elif defined(MPICH_VERSION)
#define INTERPHASE_MPI "MPICH " MPICH_VERSION
#else
#define INTERPHASE_MPI "MPI " INTERPHASE_VALUE(MPI_VERSION) "." INTERPHASE_VALUE(MPI_SUBVERSION)
#endif

#if defined(_GLIBCXX_USE_CXX11_ABI)
#define INTERPHASE_LIBRARY_ABI _GLIBCXX_USE_CXX11_ABI
#else
#define INTERPHASE_LIBRARY_ABI -1
#endif

/// What this translation unit is built against. INTERPHASE_LIGGGHTS_VERSION comes with CMake's LIGGGHTS::liggghts.
/// Static, for a plug-in must not be handed the program's.
static inline auto build_facts()
{
    const BuildFact facts[] = {
        {"LIGGGHTS", INTERPHASE_LIGGGHTS_VERSION, 0},
        {"compiler", INTERPHASE_COMPILER, 0},
        {"MPI", INTERPHASE_MPI, 0},
        {"C++ ABI (__GXX_ABI_VERSION)", nullptr, __GXX_ABI_VERSION},
        {"C++ library ABI (_GLIBCXX_USE_CXX11_ABI)", nullptr, INTERPHASE_LIBRARY_ABI},
        {"size of bigint [bytes]", nullptr, sizeof(LAMMPS_NS::bigint)},
        {"size of tagint [bytes]", nullptr, sizeof(LAMMPS_NS::tagint)},
        {"size of LAMMPS [bytes]", nullptr, sizeof(LAMMPS_NS::LAMMPS)},
        {"size of Pointers [bytes]", nullptr, sizeof(LAMMPS_NS::Pointers)},
        {"size of Fix [bytes]", nullptr, sizeof(LAMMPS_NS::Fix)},
        {"size of Atom [bytes]", nullptr, sizeof(LAMMPS_NS::Atom)},
        {"size of Comm [bytes]", nullptr, sizeof(LAMMPS_NS::Comm)},
        {"size of Domain [bytes]", nullptr, sizeof(LAMMPS_NS::Domain)},
        {"size of Force [bytes]", nullptr, sizeof(LAMMPS_NS::Force)},
        {"size of Modify [bytes]", nullptr, sizeof(LAMMPS_NS::Modify)},
        {"size of Neighbor [bytes]", nullptr, sizeof(LAMMPS_NS::Neighbor)},
        {"size of NeighList [bytes]", nullptr, sizeof(LAMMPS_NS::NeighList)},
        {"size of NeighRequest [bytes]", nullptr, sizeof(LAMMPS_NS::NeighRequest)},
        {"size of Update [bytes]", nullptr, sizeof(LAMMPS_NS::Update)},
        {"size of PluginMethod [bytes]", nullptr, sizeof(PluginMethod)},
        {"members of PluginMethod (fingerprint)", nullptr,
         fingerprint_of(&PluginMethod::name, &PluginMethod::about, &PluginMethod::tracks_parcels,
                        &PluginMethod::parcels_instead, &PluginMethod::single_collisions,
                        &PluginMethod::contacts_resolved, &PluginMethod::pair_style_borne,
                        &PluginMethod::per_collision)},
        {"size of Counter [bytes]", nullptr, sizeof(Counter)},
        {"members of Counter (fingerprint)", nullptr,
         fingerprint_of(&Counter::key, &Counter::text, &Counter::unit, &Counter::over_ranks, &Counter::worry_above,
                        &Counter::meaning, &Counter::reason, &Counter::remedy)},
        {"members of CounterValues (fingerprint)", nullptr,
         fingerprint_of(&CounterValues::count, &CounterValues::values)},
        {"size of StressState [bytes]", nullptr, sizeof(StressState)},
        {"members of StressState (fingerprint)", nullptr,
         fingerprint_of(&StressState::gradient, &StressState::solid_fraction, &StressState::mean_velocity,
                        &StressState::closing_speed, &StressState::cell_size, &StressState::relaxation_time,
                        &StressState::change)},
        {"size of StepTooLong [bytes]", nullptr, sizeof(StepTooLong)},
        {"members of StepTooLong (fingerprint)", nullptr,
         fingerprint_of(&StepTooLong::crossing_cells, &StepTooLong::beyond_relaxation, &StepTooLong::longest)},
        {"size of SolidStress [bytes]", nullptr, sizeof(SolidStress)},
        {"functions of SolidStress (fingerprint)", nullptr,
         fingerprint_of(&SolidStress::stress, &SolidStress::close_packing, &SolidStress::refuses_overfilled_start,
                        &SolidStress::states, &SolidStress::begin, &SolidStress::complaint)},
    };
    std::array<BuildFact, std::size(facts)> copy;
    std::copy(std::begin(facts), std::end(facts), copy.begin());
    return copy;
}

template <class FixStyle>
LAMMPS_NS::Fix* create(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
{
    return new FixStyle(lmp, narg, arg);
}

}  // namespace interphase

/// Makes the library that it stands in (once) a plug-in: its name, and its fix styles as {"name",
/// &interphase::create<Class>}.
#define INTERPHASE_PLUGIN(plugin_name, ...)                                                                   \
    extern "C" __attribute__((visibility("default"))) const interphase::PluginDescriptor* interphase_plugin() \
    {                                                                                                         \
        static constexpr interphase::PluginStyle styles[] = {__VA_ARGS__};                                    \
        static const auto facts = interphase::build_facts();                                                  \
        static const interphase::PluginDescriptor descriptor{                                                 \
            interphase::plugin_interface_version, facts.size(), facts.data(), plugin_name,                    \
            sizeof styles / sizeof styles[0],     styles};                                                    \
        return &descriptor;                                                                                   \
    }

/// The methods that the plug-in brings (plugin/method.hpp), as interphase::method("NAME", "who collides")...; once,
/// beside INTERPHASE_PLUGIN.
#define INTERPHASE_METHODS(...)                                                                               \
    extern "C" __attribute__((visibility("default"))) const interphase::PluginList<interphase::PluginMethod>* \
    interphase_plugin_methods()                                                                               \
    {                                                                                                         \
        static constexpr interphase::PluginMethod methods[] = {__VA_ARGS__};                                  \
        static constexpr interphase::PluginList<interphase::PluginMethod> list{std::size(methods), methods};  \
        return &list;                                                                                         \
    }

/// What its fixes count (plugin/counter.hpp): the name of a constexpr array of Counter; once, beside INTERPHASE_PLUGIN.
#define INTERPHASE_COUNTERS(counters)                                                                     \
    extern "C" __attribute__((visibility("default"))) const interphase::PluginList<interphase::Counter>*  \
    interphase_plugin_counters()                                                                          \
    {                                                                                                     \
        static constexpr interphase::PluginList<interphase::Counter> list{std::size(counters), counters}; \
        return &list;                                                                                     \
    }
