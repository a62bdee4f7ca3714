// SPDX-License-Identifier: GPL-3.0-or-later
// Says that it was built against another LIGGGHTS, with another compiler, on another MPI, and does not tell the rest.
#include <interphase/plugin.hpp>

namespace {

constexpr interphase::BuildFact facts[] = {{"LIGGGHTS", "3.7.0", 0}, {"compiler", "GCC 4", 0}, {"MPI", "MPICH 3.1", 0}};
constexpr interphase::PluginStyle styles[] = {{"test/other", nullptr}};
constexpr interphase::PluginDescriptor descriptor{
    interphase::plugin_interface_version, 3, facts, "other_build", 1, styles};

}  // namespace

extern "C" const interphase::PluginDescriptor* interphase_plugin() { return &descriptor; }
