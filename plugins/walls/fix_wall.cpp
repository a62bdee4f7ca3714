// SPDX-License-Identifier: GPL-3.0-or-later
#include "walls/fix_wall.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "atom.h"
#include "error.h"
#include "fix_mesh_surface.h"
#include "modify.h"
#include "tri_mesh.h"
#include "update.h"
#include "walls/of_all_ranks.hpp"

namespace interphase::walls {

namespace {

constexpr const char* usage =
    "; give `primitive type T xplane X` (yplane, zplane; xcylinder R Y Z, ycylinder R Z X, zcylinder R X Y) or "
    "`mesh n_meshes N meshes ID ...`";

/// As ranks tell each other of it.
struct MeshTriangle {
    double id;
    double corner[3][3] = {};    ///< [m]
    double velocity[3][3] = {};  ///< of the corners [m/s]
};

}  // namespace

FixWall::FixWall(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg)
{
    const std::string kind = narg > 3 ? arg[3] : "";
    if (kind == "primitive")
        read_primitive(narg, arg);
    else if (kind == "mesh")
        read_meshes(narg, arg);
    else
        complain("'" + kind + "' is no kind of wall" + usage);
}

void FixWall::complain(const std::string& what) const
{
    error->all(FLERR, ("Fix " + std::string(id) + " " + style + ": " + what).c_str());
}

void FixWall::demand_heeding_fix(const std::string& otherwise) const
{
    const std::string heeding = style + std::strlen("wall/");
    if (!modify->find_fix_style_strict(heeding.c_str(), 0))
        complain("there is no fix " + heeding + " that heeds this wall; add `fix ID all " + heeding + "`" + otherwise);
}

double FixWall::number(const char* word) const
{
    char* end = nullptr;
    const double value = std::strtod(word, &end);
    if (*end || end == word || !std::isfinite(value)) complain("'" + std::string(word) + "' is no number" + usage);
    return value;
}

void FixWall::read_primitive(int narg, char** arg)
{
    if (narg < 8 || std::string(arg[4]) != "type") complain(std::string("too few words") + usage);
    const double type = number(arg[5]);
    type_ = static_cast<int>(type) - 1;
    if (type != std::floor(type) || type_ < 0 || type_ >= atom->ntypes)
        complain("type " + std::string(arg[5]) + " is none of the " + std::to_string(atom->ntypes) +
                 " types of this simulation box");
    primitive_ = arg[6];
    const std::string shape = primitive_.substr(primitive_.empty() ? 0 : 1);
    const bool known = !primitive_.empty() && primitive_[0] >= 'x' && primitive_[0] <= 'z' &&
                       (shape == "plane" || shape == "cylinder");
    if (!known) complain("'" + primitive_ + "' is no primitive wall" + usage);
    const int wanted = shape == "plane" ? 1 : 3;
    if (narg != 7 + wanted)
        complain(primitive_ + " takes " + std::to_string(wanted) + " number" + (wanted > 1 ? "s" : "") + ", not " +
                 std::to_string(narg - 7) + usage);
    for (int k = 7; k < narg; ++k)
        parameters_.push_back(number(arg[k]));
    if (wanted == 3 && parameters_[0] <= 0)
        complain("the cylinder's radius is " + std::string(arg[7]) + "; give one above 0");
}

void FixWall::read_meshes(int narg, char** arg)
{
    if (narg < 8 || std::string(arg[4]) != "n_meshes" || std::string(arg[6]) != "meshes")
        complain(std::string("too few words") + usage);
    if (static_cast<int>(number(arg[5])) != narg - 7)
        complain("n_meshes is " + std::string(arg[5]) + ", but " + std::to_string(narg - 7) + " are named");
    for (int k = 7; k < narg; ++k) {
        if (!dynamic_cast<LAMMPS_NS::FixMeshSurface*>(modify->find_fix_id(arg[k])))
            complain("there is no fix mesh/surface '" + std::string(arg[k]) + "' before it in the script");
        meshes_.push_back(arg[k]);
        if (asks_for_wear(mesh(k - 7)))
            complain("mesh '" + meshes_.back() +
                     "' asks for wear, which only wall/gran gives; take `wear` away, forces stay");
    }
    loads_.resize(meshes_.size());
    ids_.resize(meshes_.size());
}

LAMMPS_NS::FixMeshSurface& FixWall::mesh(int n) const
{
    const std::string& name = meshes_[static_cast<std::size_t>(n)];
    auto* fix = dynamic_cast<LAMMPS_NS::FixMeshSurface*>(modify->find_fix_id(name.c_str()));
    if (!fix) complain("fix mesh/surface '" + name + "' has been removed");
    return *fix;
}

int FixWall::setmask() { return sums_any_forces() ? LAMMPS_NS::FixConst::POST_FORCE : 0; }

void FixWall::post_force(int)
{
    for (int n = 0; n < wall_count(); ++n)
        if (sums_forces(n))
            loads_[static_cast<std::size_t>(n)].give_to(mesh(n), ids_[static_cast<std::size_t>(n)], world);
}

bool FixWall::sums_forces(int n) const { return primitive_.empty() && walls::sums_forces(mesh(n)); }

bool FixWall::sums_any_forces() const
{
    for (int n = 0; n < wall_count(); ++n)
        if (sums_forces(n)) return true;
    return false;
}

void FixWall::push(int n, int element, const Vector& point, const Vector& impulse)
{
    loads_[static_cast<std::size_t>(n)].push(element, point, impulse / update->dt);
}

bool FixWall::travels(int n) const { return primitive_.empty() && mesh(n).mesh()->isMoving(); }

std::unique_ptr<Wall> FixWall::wall(int n)
{
    if (primitive_.empty()) return std::make_unique<TriangleWall>(mesh(n).atomTypeWall() - 1, surface_of(n));
    const int axis = primitive_[0] - 'x';
    if (parameters_.size() == 1) return std::make_unique<PlaneWall>(type_, axis, parameters_[0]);
    return std::make_unique<CylinderWall>(type_, axis, parameters_[0], parameters_[1], parameters_[2]);
}

void* FixWall::extract(const char* name, int& dimension)
{
    dimension = 0;
    if (std::string(name) != extract_wall_gaps) return nullptr;
    asked_of_.clear();
    for (int n = 0; n < wall_count(); ++n)
        asked_of_.push_back(wall(n));
    return static_cast<WallGaps*>(this);
}

double FixWall::gap(const double centre[3], double radius) const
{
    double least = radius;
    std::vector<WallPoint> points;
    const Place sphere{{centre[0], centre[1], centre[2]}, radius};
    for (const auto& wall : asked_of_)
        if (wall->may_touch(sphere, 0)) wall->near(sphere, 0, points);
    for (const WallPoint& point : points)
        least = std::min(least, point.gap);
    return least;
}

Surface FixWall::surface_of(int n)
{
    LAMMPS_NS::FixMeshSurface& fix = mesh(n);
    using NodeVelocities = LAMMPS_NS::MultiVectorContainer<double, 3, 3>;
    LAMMPS_NS::TriMesh& mesh = *fix.triMesh();
    // of meshes that move and of those that slide along themselves (surface_vel)
    auto* velocities = mesh.prop().getElementProperty<NodeVelocities>("v");
    std::vector<MeshTriangle> mine(static_cast<std::size_t>(mesh.sizeLocal()));
    for (int t = 0; t < mesh.sizeLocal(); ++t) {
        MeshTriangle& triangle = mine[static_cast<std::size_t>(t)];
        triangle.id = mesh.id(t);
        for (int corner = 0; corner < 3; ++corner) {
            mesh.node(t, corner, triangle.corner[corner]);
            if (velocities) std::copy_n(velocities->begin()[t][corner], 3, triangle.velocity[corner]);
        }
    }
    // a mesh has few triangles against the particles, and particles roam over all of it
    std::vector<MeshTriangle> all = of_all_ranks(mine, world);
    // they change rank as they move: what is remembered of them goes by their order
    std::sort(all.begin(), all.end(), [](const MeshTriangle& a, const MeshTriangle& b) { return a.id < b.id; });

    std::vector<int>& ids = ids_[static_cast<std::size_t>(n)];
    ids.clear();
    for (const MeshTriangle& triangle : all)
        ids.push_back(static_cast<int>(triangle.id));

    Surface surface;
    surface.travels = fix.mesh()->isMoving();
    bool any = false;
    for (const MeshTriangle& triangle : all) {
        surface.triangles.emplace_back();
        surface.velocity.emplace_back();
        for (std::size_t corner = 0; corner < 3; ++corner) {
            surface.triangles.back()[corner] = to_vector(triangle.corner[corner]);
            surface.velocity.back()[corner] = to_vector(triangle.velocity[corner]);
            any = any || !surface.velocity.back()[corner].isZero(0);
        }
    }
    if (!any) surface.velocity.clear();
    return surface;
}

}  // namespace interphase::walls
