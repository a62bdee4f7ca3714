// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "settings/method.hpp"

namespace interphase::test {

/// An engine's own method that tracks particles, and whose contacts take many steps.
inline Method springs()
{
    Method method;
    method.name = "SPRINGS";
    method.about = "springs";
    method.collisions_of_plugin = method.tracks_parcels = false;
    method.with_parcels = "PARCELS";
    method.resolves_contacts = method.bears_pair_style = true;
    return method;
}

/// The same for parcels.
inline Method parcels()
{
    Method method = springs();
    method.name = "PARCELS";
    method.tracks_parcels = true;
    method.with_parcels = "";
    return method;
}

/// Of a plug-in.
inline Method impulses()
{
    Method method;
    method.name = "IMPULSES";
    method.about = "impulses";
    method.plugin = "impulses";
    method.tracks_parcels = false;
    method.steps_per_collision = 1;
    return method;
}

/// Likewise, without single collisions.
inline Method mean()
{
    Method method;
    method.name = "MEAN";
    method.about = "a mean";
    method.plugin = "mean";
    method.single_collisions = false;
    return method;
}

/// For plug-ins that bring no method.
inline Method whatever()
{
    Method method;
    method.name = "WHATEVER";
    method.about = "whatever they do";
    method.bears_pair_style = true;
    return method;
}

/// Knows all of these, those of a plug-in where the plug-in of their name is asked for.
class FakeMethods : public MethodSource {
public:
    Methods methods(const std::vector<std::string>& plugins) const override
    {
        Methods all{springs(), parcels(), whatever()};
        for (const Method& method : {impulses(), mean()})
            if (std::find(plugins.begin(), plugins.end(), method.plugin) != plugins.end()) all.push_back(method);
        return all;
    }
    std::string plugin_with(const std::string& name) const override
    {
        for (const Method& method : {impulses(), mean()})
            if (method.name == name) return method.plugin;
        return "";
    }
};

}  // namespace interphase::test
