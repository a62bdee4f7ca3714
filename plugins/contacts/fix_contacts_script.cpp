// SPDX-License-Identifier: GPL-3.0-or-later
// What a FixContacts takes from the script, and what it does not bear in it.
#include <algorithm>

#include "contacts/fix_contacts.hpp"
#include "script/script.hpp"

namespace interphase::contacts {

namespace {

/// Of a text, below 0, the same on every machine (FNV-1a); doubles hold it exactly.
std::int64_t key_of(const std::string& text)
{
    std::uint64_t hash = 14695981039346656037u;
    for (const unsigned char letter : text)
        hash = (hash ^ letter) * 1099511628211u;
    return -1 - static_cast<std::int64_t>(hash >> 12);
}

}  // namespace

void FixContacts::complain(const std::string& what) const
{
    error->all(FLERR, ("Fix " + std::string(id) + " " + style + ": " + what).c_str());
}

void FixContacts::complain_alone(const std::string& what) const
{
    error->one(FLERR, ("Fix " + std::string(id) + " " + style + ": " + what).c_str());
}

void FixContacts::init()
{
    // A dashpot and friction need the velocities of ghosts: copies of spheres that belong to other ranks, or to the
    // other side of a periodic box.
    if (!comm->ghost_velocity)
        complain("forces need the velocities of other ranks' spheres; give `communicate single vel yes`");
    for (int k = 0; k < modify->nfix; ++k) {
        const Fix& other = *modify->fix[k];
        if (!force->pair && std::string(other.style).rfind("wall/gran", 0) == 0)
            complain("fix " + std::string(other.id) + " (" + other.style +
                     ") takes its forces from a pair_style, and there is none. Write " + wall_style_ +
                     " for it, with the words from `primitive` or `mesh` on");
    }
    reach_.begin();
    if (reach_.largest_radius() > 0 && !force->pair) script::sort_by_default(*lmp, 4 * reach_.largest_radius());
}

BetweenTypes FixContacts::between_types(const char* name, const std::function<bool(double)>& holds, const char* demand)
{
    BetweenTypes values(atom->ntypes);
    script::read_between_types(*lmp, *this, name, {0, script::unbounded}, [&](int a, int b, double value) {
        if (!holds(value))
            complain("fix property/global " + std::string(name) + " is " + std::to_string(value) + " between types " +
                     std::to_string(a + 1) + " and " + std::to_string(b + 1) + "; " + demand);
        values.between(a, b) = value;
    });
    return values;
}

void FixContacts::collect_walls()
{
    walls_.clear();
    keys_.clear();
    for (int k = 0; k < modify->nfix; ++k) {
        if (modify->fix[k]->style != wall_style_) continue;
        auto* fix = dynamic_cast<FixContactsWall*>(modify->fix[k]);
        if (!fix) continue;
        const std::size_t before = walls_.all().size();
        walls_.add(*fix);
        for (std::size_t n = before; n < walls_.all().size(); ++n) {
            const int type = walls_.all()[n]->type();
            if (type < 0 || type >= atom->ntypes)
                complain("the wall of fix " + std::string(fix->id) + " has type " + std::to_string(type + 1) +
                         ", none of the " + std::to_string(atom->ntypes) +
                         " types of the simulation box; give it one of them");
            keys_.push_back(key_of(std::string(fix->id) + "/" + std::to_string(n - before)));
        }
    }
}

void FixContactsWall::init()
{
    const auto heeds = [this](Fix* fix) {
        const auto* contacts = dynamic_cast<const FixContacts*>(fix);
        return contacts && contacts->wall_style() == style;
    };
    if (std::none_of(modify->fix, modify->fix + modify->nfix, heeds))
        complain(
            "no fix heeds this wall; add that of the plug-in which brings the wall, or use wall/gran with a "
            "pair_style");
}

}  // namespace interphase::contacts
