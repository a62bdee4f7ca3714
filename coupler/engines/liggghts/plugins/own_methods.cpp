// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/plugins/own_methods.hpp"

namespace interphase {

namespace {

Method springs(const char* name, const char* about)
{
    Method method;
    method.name = name;
    method.about = about;
    method.collisions_of_plugin = false;
    method.resolves_contacts = method.bears_pair_style = true;
    return method;
}

}  // namespace

Methods own_methods()
{
    Method dem = springs("DEM", "springs and dashpots of LIGGGHTS's pair styles");
    dem.tracks_parcels = false;
    dem.with_parcels = "CGPM";
    Method any;
    any.name = "PLUGIN";
    any.about = "whatever a fix of a plug-in does that brings no method";
    any.bears_pair_style = true;
    return {dem, springs("CGPM", "the same springs and dashpots, between parcels"), any};
}

}  // namespace interphase
