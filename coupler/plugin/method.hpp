// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase {

/// A collision method that a plug-in brings, `method NAME;` of system/couplingDict. What is not said otherwise: it
/// tracks parcels, whose weight may be 1; spheres collide one by one; nothing else in the script makes contacts; where
/// the script tells a collision time t_c (kn and coefficientRestitution), a solid step is t_c/20.
///
///     INTERPHASE_METHODS(interphase::method("BOUNCY", "soft spheres").of_particles().resolving_contacts())
struct PluginMethod {
    const char* name;   ///< letters, digits and `_`
    const char* about;  ///< who collides, in a few words
    bool tracks_parcels;
    const char* parcels_instead;
    bool single_collisions;
    bool contacts_resolved;
    bool pair_style_borne;
    double per_collision;

    /// Every particle is tracked: weights are 1. `with_parcels`: the method to take for others, if there is one.
    constexpr PluginMethod of_particles(const char* with_parcels = "") const
    {
        PluginMethod changed = *this;
        changed.tracks_parcels = false;
        changed.parcels_instead = with_parcels;
        return changed;
    }
    /// A solid step is t_c/`number` where the case does not say.
    constexpr PluginMethod steps_per_collision(double number) const
    {
        PluginMethod changed = *this;
        changed.per_collision = number;
        return changed;
    }
    /// A contact lasts over many solid steps, as with springs and dashpots: less than ten in t_c are refused.
    constexpr PluginMethod resolving_contacts() const
    {
        PluginMethod changed = *this;
        changed.contacts_resolved = true;
        return changed;
    }
    /// Spheres feel each other through a mean, such as a stress, not one by one: they may overlap, there is no
    /// collision time, and a solid step is a gas step where the case does not say.
    constexpr PluginMethod without_single_collisions() const
    {
        PluginMethod changed = *this;
        changed.single_collisions = false;
        return changed;
    }
    /// A pair style of LIGGGHTS may make contacts, too. It would count them twice where the method has its own.
    constexpr PluginMethod beside_pair_style() const
    {
        PluginMethod changed = *this;
        changed.pair_style_borne = true;
        return changed;
    }
};

constexpr PluginMethod method(const char* name, const char* about)
{
    return {name, about, true, "", true, false, false, 20};
}

}  // namespace interphase
