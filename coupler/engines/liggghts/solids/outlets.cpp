// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/outlets.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "atom.h"
#include "base/vector.hpp"
#include "fix_massflow_mesh.h"
#include "fix_mesh_surface.h"
#include "fix_property_atom.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"

namespace interphase {

namespace {

/// What a fix massflow/mesh keeps to itself.
struct Inside : LAMMPS_NS::FixMassflowMesh {
    static bool counts_once(LAMMPS_NS::FixMassflowMesh& fix) { return fix.*(&Inside::once_); }
    static LAMMPS_NS::TriMesh& mesh(LAMMPS_NS::FixMassflowMesh& fix) { return *(fix.*(&Inside::fix_mesh_))->triMesh(); }
    /// Of each particle: -1 never listed, 0 on the near side, 1 on the far side, 2 counted.
    static double* sides(LAMMPS_NS::FixMassflowMesh& fix) { return (fix.*(&Inside::fix_counter_))->vector_atom; }
    static bool will_delete(LAMMPS_NS::FixMassflowMesh& fix, int id)
    {
        const std::vector<int>& ids = fix.*(&Inside::atom_tags_delete_);
        return std::find(ids.begin(), ids.end(), id) != ids.end();
    }
};

/// Whether the way from `a` to `b` meets the triangle; its edges belong to it.
bool meets(const Vector& a, const Vector& b, const Vector (&corner)[3])
{
    const Vector normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const double before = normal.dot(a - corner[0]), after = normal.dot(b - corner[0]);
    if (before * after > 0 || before == after) return false;
    const Vector at = a + before / (before - after) * (b - a);
    constexpr double edge = 1e-9;  // of the triangle: no way between two that share an edge
    for (int n = 0; n < 3; ++n) {
        const Vector& from = corner[n];
        if (normal.dot((corner[(n + 1) % 3] - from).cross(at - from)) < -edge * normal.squaredNorm()) return false;
    }
    return true;
}

bool came_through(LAMMPS_NS::TriMesh& mesh, const Vector& from, const Vector& to)
{
    for (int n = 0; n < mesh.sizeLocal() + mesh.sizeGhost(); ++n) {
        Vector corner[3];
        for (int k = 0; k < 3; ++k)
            mesh.node(n, k, corner[k].data());
        if (meets(from, to, corner)) return true;
    }
    return false;
}

}  // namespace

Outlets::Outlets(const LAMMPS_NS::LAMMPS& lmp)
{
    for (int n = 0; n < lmp.modify->nfix; ++n) {
        auto* fix = dynamic_cast<LAMMPS_NS::FixMassflowMesh*>(lmp.modify->fix[n]);
        if (fix && Inside::counts_once(*fix)) outlets_.push_back(fix);
    }
}

long Outlets::correct(const LAMMPS_NS::LAMMPS& lmp) const
{
    const LAMMPS_NS::Atom& atom = *lmp.atom;
    long corrected = 0;
    for (LAMMPS_NS::FixMassflowMesh* fix : outlets_) {
        double* side = Inside::sides(*fix);
        for (int i = 0; i < atom.nlocal; ++i) {
            constexpr double far = 1, near = 0;
            if (side[i] != far || !(atom.mask[i] & fix->groupbit)) continue;
            const Vector to(atom.x[i][0], atom.x[i][1], atom.x[i][2]);
            const Vector from = to - lmp.update->dt * Vector(atom.v[i][0], atom.v[i][1], atom.v[i][2]);
            if (!came_through(Inside::mesh(*fix), from, to) || Inside::will_delete(*fix, atom.tag[i])) continue;
            side[i] = near;
            ++corrected;
        }
    }
    return corrected;
}

}  // namespace interphase
