// SPDX-License-Identifier: GPL-3.0-or-later
#include "walls/mesh_load.hpp"

#include <Eigen/Geometry>

#include "fix_mesh_surface.h"
#include "mesh_module_stress.h"
#include "tri_mesh.h"
#include "walls/of_all_ranks.hpp"

namespace interphase::walls {

namespace {

/// As ranks tell each other of it.
struct ElementLoad {
    double element;
    double force[3];  ///< [N]
};

LAMMPS_NS::MeshModuleStress* sums_of(LAMMPS_NS::FixMeshSurface& mesh)
{
    return dynamic_cast<LAMMPS_NS::MeshModuleStress*>(mesh.get_module("stress"));
}

}  // namespace

bool sums_forces(LAMMPS_NS::FixMeshSurface& mesh)
{
    LAMMPS_NS::MeshModuleStress* sums = sums_of(mesh);
    return sums && sums->trackStress();
}

bool asks_for_wear(LAMMPS_NS::FixMeshSurface& mesh)
{
    LAMMPS_NS::MeshModuleStress* sums = sums_of(mesh);
    return sums && sums->trackWear();
}

void MeshLoad::push(int element, const Vector& point, const Vector& force)
{
    force_ += force;
    torque_ += point.cross(force);
    on_elements_.emplace(element, Vector::Zero()).first->second += force;
}

void MeshLoad::give_to(LAMMPS_NS::FixMeshSurface& mesh, const std::vector<int>& ids, MPI_Comm world)
{
    LAMMPS_NS::MeshModuleStress& sums = *sums_of(mesh);
    constexpr int reference_point = 6;  // of the numbers that it shows
    Vector about;
    for (int axis = 0; axis < 3; ++axis)
        about[axis] = sums.compute_vector(reference_point + axis);
    Vector torque = torque_ - about.cross(force_);
    sums.add_global_external_contribution(force_.data(), torque.data());

    // a triangle may have gone to another rank since the particles met it
    std::vector<ElementLoad> mine;
    for (const auto& [element, force] : on_elements_)
        mine.push_back({static_cast<double>(element), {force[0], force[1], force[2]}});
    std::map<int, Vector> by_id;
    for (const ElementLoad& load : of_all_ranks(mine, world))
        by_id.emplace(ids[static_cast<std::size_t>(load.element)], Vector::Zero()).first->second +=
            to_vector(load.force);
    LAMMPS_NS::TriMesh& triangles = *mesh.triMesh();
    auto& forces = *triangles.prop().getElementProperty<LAMMPS_NS::VectorContainer<double, 3>>("f");
    for (int t = 0; t < triangles.sizeLocal(); ++t)
        if (const auto found = by_id.find(triangles.id(t)); found != by_id.end())
            for (int axis = 0; axis < 3; ++axis)
                forces(t)[axis] += found->second[axis];
    *this = {};
}

}  // namespace interphase::walls
