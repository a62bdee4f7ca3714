// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/overlaps.hpp"

#include <mpi.h>

#include <algorithm>
#include <functional>

#include "atom.h"
#include "base/close_spheres.hpp"
#include "fix_mesh_surface.h"
#include "fix_neighlist_mesh.h"
#include "lammps.h"
#include "modify.h"
#include "plugin/wall_gaps.hpp"
#include "primitive_wall.h"
#include "tri_mesh.h"

// The package lacks the headers in which LIGGGHTS lists its contact models. The next header asks for their numbers, and
// uses none of them in what is called here.
#define CONTACT_MODEL_CONSTANTS_H_  // the guard of the header that would read them
namespace LIGGGHTS::ContactModels {
constexpr int NORMAL_OFF = 9, TANGENTIAL_OFF = 0, COHESION_OFF = 0, ROLLING_OFF = 0;
}
#include "fix_wall_gran.h"

namespace interphase {

namespace {

using Seen = std::function<void(int first, int second, double depth)>;  ///< second below 0: a wall

/// Each pair that touches is seen by one rank: the one that owns the particle of the lower number.
void see_pairs(const LAMMPS_NS::Atom& atom, const Seen& see)
{
    const int count = atom.nlocal + atom.nghost;
    if (count == 0) return;
    const CloseSpheres spheres(atom.x[0], atom.radius, static_cast<std::size_t>(count));
    spheres.for_each_overlap([&](std::size_t a, std::size_t b, double depth) {
        const int i = static_cast<int>(a), j = static_cast<int>(b);
        if (atom.tag[i] == atom.tag[j]) return;
        const bool i_first = atom.tag[i] < atom.tag[j];
        if ((i_first ? i : j) >= atom.nlocal) return;
        see(i_first ? i : j, i_first ? j : i, depth / std::min(atom.radius[i], atom.radius[j]));
    });
}

void see_meshes(const LAMMPS_NS::Atom& atom, const LAMMPS_NS::FixWallGran& wall, const Seen& see)
{
    std::vector<double> depth(static_cast<std::size_t>(atom.nlocal), 0.0);  // a sphere may touch several triangles
    for (int m = 0; m < wall.n_meshes(); ++m) {
        LAMMPS_NS::FixMeshSurface& fix = *wall.mesh_list()[m];
        if (!fix.hasNeighList()) continue;
        LAMMPS_NS::TriMesh& mesh = *fix.triMesh();
        for (int t = 0; t < mesh.sizeLocal() + mesh.sizeGhost(); ++t)
            for (const int i : fix.meshNeighlist()->get_contact_list(t)) {
                if (i >= atom.nlocal) continue;
                double delta[3];
                int place = 0;
                const double gap = mesh.resolveTriSphereContact(i, t, atom.radius[i], atom.x[i], delta, place);
                double& deepest = depth[static_cast<std::size_t>(i)];
                deepest = std::max(deepest, -gap / atom.radius[i]);
            }
    }
    for (int i = 0; i < atom.nlocal; ++i)
        see(i, -1, depth[static_cast<std::size_t>(i)]);
}

/// Whether the fix is a wall; then all that its spheres overlap with it is seen.
bool see_wall(LAMMPS_NS::LAMMPS& lmp, LAMMPS_NS::Fix& fix, const Seen& see)
{
    const LAMMPS_NS::Atom& atom = *lmp.atom;
    if (auto* wall = dynamic_cast<LAMMPS_NS::FixWallGran*>(&fix)) {
        if (wall->is_mesh_wall())
            see_meshes(atom, *wall, see);
        else if (LAMMPS_NS::PrimitiveWall* primitive = wall->primitiveWall())
            for (int i = 0; i < atom.nlocal; ++i) {
                double delta[3];
                const double gap = primitive->resolveContact(atom.x[i], atom.radius[i], delta);
                if (atom.mask[i] & fix.groupbit) see(i, -1, -gap / atom.radius[i]);
            }
        return true;
    }
    if (std::string(fix.style).rfind("wall/", 0) != 0) return false;
    int dimension = 0;
    const auto* wall = static_cast<const WallGaps*>(fix.extract(extract_wall_gaps, dimension));
    if (!wall) return false;
    for (int i = 0; i < atom.nlocal; ++i)
        see(i, -1, -wall->gap(atom.x[i], atom.radius[i]) / atom.radius[i]);
    return true;
}

struct Deepest {
    double depth = 0, centre[3] = {0, 0, 0}, particle[2] = {0, 0};
};

/// Of all ranks, by what this one sees in `look`.
template <class Look>
Overlaps collected(const Communicator& comm, const LAMMPS_NS::Atom& atom, double least, const std::string& with,
                   const Look& look)
{
    Overlaps found;
    found.with = with;
    Deepest mine;
    look([&](int i, int j, double depth) {
        if (!(depth > least)) return;
        ++found.number;
        if (depth <= mine.depth) return;
        mine = {depth,
                {atom.x[i][0], atom.x[i][1], atom.x[i][2]},
                {static_cast<double>(atom.tag[i]), j < 0 ? 0.0 : atom.tag[j]}};
    });
    found.number = comm.sum(found.number);
    for (const Deepest& of_rank : comm.all_gather(mine)) {
        if (of_rank.depth <= found.deepest) continue;
        found.deepest = of_rank.depth;
        found.centre = Vector(of_rank.centre[0], of_rank.centre[1], of_rank.centre[2]);
        for (int k = 0; k < 2; ++k)
            found.particle[k] = static_cast<int>(of_rank.particle[k]);
    }
    return found;
}

}  // namespace

std::vector<Overlaps> overlaps(const Communicator& comm, LAMMPS_NS::LAMMPS& lmp, double least, bool among_particles)
{
    const LAMMPS_NS::Atom& atom = *lmp.atom;
    std::vector<Overlaps> all;
    const auto keep = [&all](const Overlaps& found) {
        if (found.number > 0) all.push_back(found);
    };
    if (among_particles)
        keep(collected(comm, atom, least, "each other", [&](const Seen& see) { see_pairs(atom, see); }));
    for (int k = 0; k < lmp.modify->nfix; ++k) {
        LAMMPS_NS::Fix& fix = *lmp.modify->fix[k];
        keep(collected(comm, atom, least, std::string("fix ") + fix.id + " (" + fix.style + ")",
                       [&](const Seen& see) { see_wall(lmp, fix, see); }));
    }
    return all;
}

}  // namespace interphase
