// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "contacts/cells.hpp"
#include "contacts/contact.hpp"
#include "contacts/ghost_reach.hpp"
#include "plugin/plugin.hpp"
#include "walls/fix_wall.hpp"
#include "walls/wall_set.hpp"

namespace interphase::contacts {

/// The base of a fix style that pushes spheres apart where they touch. It finds the contacts of the fix's group, among
/// each other and with the walls of the fixes of style `wall_style`, on any number of ranks, and hands each to a law.
/// Spheres may be inserted, removed and grow while the run goes on. It adds forces and torques; another fix, such as
/// nve/sphere, moves the spheres.
///
/// A fix of this base overrides post_force() and calls each_contact() there, once.
class FixContacts : public LAMMPS_NS::Fix {
public:
    FixContacts(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg, const char* wall_style);

    int setmask() override;
    void init() override;
    void setup(int) override;
    void setup_pre_neighbor() override { reach_.renew(); }
    void pre_neighbor() override { reach_.renew(); }
    double extend_cut_ghost() override { return reach_.distance(); }
    int pack_comm(int n, int* list, double* buffer, int, int*) override;
    void unpack_comm(int n, int first, double* buffer) override;

    const std::string& wall_style() const { return wall_style_; }

protected:
    using Partner = std::int64_t;  ///< id of a sphere, above 0, or the key of a wall, below 0

    /// law(contact) -> Push, for each contact of each of this rank's spheres. A contact of two spheres is asked for
    /// twice, once for each: what it does to one must be the opposite of what it does to the other. Collective.
    template <class Law>
    void each_contact(const Law& law)
    {
        begin_step();
        visit([&](int, Partner, const Contact& contact) { return law(contact); });
        end_step(0);
    }

    /// Reads `fix ID all property/global NAME peratomtypepair ...`. A value for which `holds` is false ends the run
    /// with the words of `demand`, such as "give numbers above 0 N/m". Collective.
    BetweenTypes between_types(const char* name, const std::function<bool(double)>& holds, const char* demand);

    /// Ends the run; the message begins with the fix's id and style. Collective.
    void complain(const std::string& what) const;

    // --- for each_contact() of this class and of those that add to it ---
    void begin_step();
    /// `longest`: whatever a class wants to know the largest of, over all ranks; see longest().
    void end_step(int longest);
    int longest() const { return longest_; }

    /// visitor(i, partner, contact) -> Push, for each contact of each of this rank's spheres i.
    template <class Visitor>
    void visit(const Visitor& visitor)
    {
        for (int i = 0; i < atom->nlocal; ++i) {
            if (!(atom->mask[i] & groupbit)) continue;
            cells_.near(atom->x[i], [&](int j) {
                if (j == i || !overlap(i, j) || !(atom->mask[j] & groupbit)) return;
                touch(i, j);
                const Partner partner = atom->tag[j];
                push(i, partner, visitor(i, partner, contact_));
            });
            for (std::size_t w = 0; w < keys_.size(); ++w) {
                const walls::Wall& wall = *walls_.all()[w];
                find_wall_points(i, wall);
                for (const walls::WallPoint& point : points_) {
                    touch_wall(i, point, wall.type());
                    const Push given = visitor(i, keys_[w], contact_);
                    push(i, keys_[w], given);
                    tell_wall(i, w, point.element, given);
                }
            }
        }
    }

private:
    void complain_alone(const std::string& what) const;  ///< as complain(), of one rank
    bool overlap(int i, int j) const
    {
        const double *x = atom->x[i], *other = atom->x[j], reach = atom->radius[i] + atom->radius[j];
        const double dx = x[0] - other[0], dy = x[1] - other[1], dz = x[2] - other[2];
        return dx * dx + dy * dy + dz * dz < reach * reach;
    }
    void touch(int i, int j);
    void find_wall_points(int i, const walls::Wall& wall);
    void touch_wall(int i, const walls::WallPoint& point, int type);
    void push(int i, Partner partner, const Push& push);
    /// What sphere i, which was given `push`, does to the wall.
    void tell_wall(int i, std::size_t wall, int element, const Push& push) const;

    void collect_walls();

    std::string wall_style_;
    GhostReach reach_;
    int longest_ = 0;
    bool in_setup_ = false;
    Cells cells_;
    walls::WallSet walls_;
    std::vector<Partner> keys_;  ///< of each wall: the same in every run that names the wall alike
    std::vector<walls::WallPoint> points_;
    Contact contact_{};  ///< the one that is being looked at
    double arm_ = 0;     ///< from the sphere's centre to it [m]
};

/// The fix style of the walls that a FixContacts heeds; walls/fix_wall.hpp has its words.
class FixContactsWall : public walls::FixWall {
public:
    using FixWall::FixWall;
    void init() override;
};

}  // namespace interphase::contacts
