// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fix.h"
#include "plugin/wall_gaps.hpp"
#include "walls/mesh_load.hpp"
#include "walls/triangle_wall.hpp"

namespace LAMMPS_NS {
class FixMeshSurface;
}

namespace interphase::walls {

/// The part of a fix style for walls that names them, as `wall/gran` does:
///
///     fix ID all wall/STYLE primitive type T xplane X | yplane Y | zplane Z
///     fix ID all wall/STYLE primitive type T xcylinder R Y Z | ycylinder R Z X | zcylinder R X Y
///     fix ID all wall/STYLE mesh n_meshes N meshes MESH_1 ... MESH_N
///
/// Anything else stops the run with an error of LIGGGHTS.
class FixWall : public LAMMPS_NS::Fix, public WallGaps {
public:
    FixWall(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

    int setmask() override;
    /// Tells the meshes of style mesh/surface/stress what particles did to them since the last step.
    void post_force(int) override;

    /// What the coupler asks at a run's start. Collective.
    void* extract(const char* name, int& dimension) override;
    double gap(const double centre[3], double radius) const override;

    /// How many walls it has.
    int wall_count() const { return primitive_.empty() ? static_cast<int>(meshes_.size()) : 1; }
    /// One of them as it stands and moves now. Collective.
    std::unique_ptr<Wall> wall(int n);
    /// Whether it moves from where it stands.
    bool travels(int n) const;

    /// Whether it wants to know what particles do to it.
    bool sums_forces(int n) const;
    /// That they gave it an impulse [kg m/s] in one step. `element`: as WallPoint has it; `point`: where [m].
    void push(int n, int element, const Vector& point, const Vector& impulse);

    /// Whether it is for the fixes of that style: it is `wall/STYLE`.
    bool is_heeded_by(const std::string& asking) const { return style == "wall/" + asking; }

protected:
    /// Ends the run where the script has no fix of the style that the wall is for. `otherwise`: a remedy beside that of
    /// adding it. Collective.
    void demand_heeding_fix(const std::string& otherwise = "") const;
    /// Ends the run. Collective.
    void complain(const std::string& what) const;

private:
    void read_primitive(int narg, char** arg);
    void read_meshes(int narg, char** arg);
    double number(const char* word) const;
    LAMMPS_NS::FixMeshSurface& mesh(int n) const;
    bool sums_any_forces() const;
    Surface surface_of(int n);

    int type_ = 0;
    std::string primitive_;
    std::vector<double> parameters_;
    std::vector<std::string> meshes_;
    std::vector<std::vector<int>> ids_;            ///< of each mesh: of its triangles, by element
    std::vector<MeshLoad> loads_;                  ///< on each mesh, of which it has not been told
    std::vector<std::unique_ptr<Wall>> asked_of_;  ///< the walls as they stood when gaps were asked for
};

}  // namespace interphase::walls
