// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpi.h>

#include <map>
#include <vector>

#include "base/vector.hpp"

namespace LAMMPS_NS {
class FixMeshSurface;
}

namespace interphase::walls {

/// Whether a mesh is of a style that sums up what particles do to it (mesh/surface/stress).
bool sums_forces(LAMMPS_NS::FixMeshSurface& mesh);
/// Whether it asks for wear, which forces alone do not give.
bool asks_for_wear(LAMMPS_NS::FixMeshSurface& mesh);

/// What particles did to such a mesh since it was told of it. LIGGGHTS clears its sums before it computes forces and
/// adds them up over the ranks afterwards; between the two it has to be told.
class MeshLoad {
public:
    /// A force [N] on a triangle at a place [m]. `element`: as WallPoint has it.
    void push(int element, const Vector& point, const Vector& force);

    /// Tells the mesh and forgets. `ids`: of its triangles, by element. Collective.
    void give_to(LAMMPS_NS::FixMeshSurface& mesh, const std::vector<int>& ids, MPI_Comm world);

private:
    Vector force_ = Vector::Zero(), torque_ = Vector::Zero();  ///< all of it; about the origin [N, N m]
    std::map<int, Vector> on_elements_;                        ///< [N]
};

}  // namespace interphase::walls
