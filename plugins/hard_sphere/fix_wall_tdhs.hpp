// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fix.h"
#include "hard_sphere/triangle_wall.hpp"

namespace LAMMPS_NS {
class FixMeshSurface;
}

namespace interphase::hard_sphere {

/// The LIGGGHTS fix style `wall/tdhs`: walls for fix tdhs, named as those of `wall/gran`:
///
///     fix ID all wall/tdhs primitive type T xplane X | yplane Y | zplane Z
///     fix ID all wall/tdhs primitive type T xcylinder R Y Z | ycylinder R Z X | zcylinder R X Y
///     fix ID all wall/tdhs mesh n_meshes N meshes MESH_1 ... MESH_N
class FixWallTdhs : public LAMMPS_NS::Fix {
public:
    static constexpr const char* style_name = "wall/tdhs";

    FixWallTdhs(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

    int setmask() override { return 0; }
    void init() override;

    /// Adds this fix's walls as they stand now. Collective.
    void add_walls(std::vector<std::unique_ptr<Wall>>& walls) const;

private:
    void read_primitive(int narg, char** arg);
    void read_meshes(int narg, char** arg);
    void complain(const std::string& what) const;
    double number(const char* word) const;
    std::vector<Triangle> all_triangles(LAMMPS_NS::FixMeshSurface& fix) const;

    int type_ = 0;
    std::string primitive_;
    std::vector<double> parameters_;
    std::vector<std::string> meshes_;
};

}  // namespace interphase::hard_sphere
