// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace interphase {

/// A way to handle collisions: all that the coupler knows of it, as the engine or a plug-in says it.
struct Method {
    std::string name;                  ///< as `method NAME;` of a case names it
    std::string about;                 ///< who collides, in a few words
    std::string plugin;                ///< that brings it; empty: the engine itself
    bool collisions_of_plugin = true;  ///< by a fix of a plug-in, whichever brings it
    bool tracks_parcels = true;        ///< so that a weight above 1 has a meaning
    std::string with_parcels;          ///< of one that does not: the method to take instead; empty: none
    bool single_collisions = true;     ///< so that there is a collision time; without, a solid step is a gas step
    bool resolves_contacts = false;    ///< over many solid steps each, as springs and dashpots need it
    bool bears_pair_style = false;     ///< contacts of the engine's own beside it
    double steps_per_collision = 20;   ///< where the case does not say
};

using Methods = std::vector<Method>;

/// Knows the methods that there are.
class MethodSource {
public:
    virtual ~MethodSource() = default;

    /// The engine's own, the default first, then those that these plug-ins bring, which are named as a case does. A
    /// UserError where one cannot be had, or two bring the same method. Collective.
    virtual Methods methods(const std::vector<std::string>& plugins) const = 0;

    /// The name of a plug-in at hand that brings the method; empty where none does.
    virtual std::string plugin_with(const std::string& method) const = 0;
};

/// "give it the weight 1, or take method CGHS": `otherwise` and the method that tracks parcels instead, if there is
/// one.
std::string or_with_parcels(const std::string& otherwise, const Method& method);

}  // namespace interphase
