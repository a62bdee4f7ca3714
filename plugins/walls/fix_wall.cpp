// SPDX-License-Identifier: GPL-3.0-or-later
#include "walls/fix_wall.hpp"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "atom.h"
#include "error.h"
#include "fix_mesh_surface.h"
#include "modify.h"
#include "tri_mesh.h"

namespace interphase::walls {

namespace {

constexpr const char* usage =
    "; give `primitive type T xplane X` (yplane, zplane; xcylinder R Y Z, ycylinder R Z X, zcylinder R X Y) or "
    "`mesh n_meshes N meshes ID ...`";

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
    }
}

void FixWall::add_walls(std::vector<std::unique_ptr<Wall>>& walls) const
{
    if (!primitive_.empty()) {
        const int axis = primitive_[0] - 'x';
        if (parameters_.size() == 1)
            walls.push_back(std::make_unique<PlaneWall>(type_, axis, parameters_[0]));
        else
            walls.push_back(
                std::make_unique<CylinderWall>(type_, axis, parameters_[0], parameters_[1], parameters_[2]));
        return;
    }
    for (const std::string& name : meshes_) {
        auto* fix = dynamic_cast<LAMMPS_NS::FixMeshSurface*>(modify->find_fix_id(name.c_str()));
        if (!fix) complain("fix mesh/surface '" + name + "' has been removed");
        if (fix->mesh()->isMoving())
            complain("mesh '" + name + "' moves; only resting meshes are known here. Take away its fix move/mesh");
        walls.push_back(std::make_unique<TriangleWall>(fix->atomTypeWall() - 1, all_triangles(*fix)));
    }
}

void* FixWall::extract(const char* name, int& dimension)
{
    dimension = 0;
    if (std::string(name) != extract_wall_gaps) return nullptr;
    asked_of_.clear();
    add_walls(asked_of_);
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

std::vector<Triangle> FixWall::all_triangles(LAMMPS_NS::FixMeshSurface& fix) const
{
    LAMMPS_NS::TriMesh& mesh = *fix.triMesh();
    std::vector<double> mine;
    for (int t = 0; t < mesh.sizeLocal(); ++t)
        for (int corner = 0; corner < 3; ++corner) {
            double x[3];
            mesh.node(t, corner, x);
            mine.insert(mine.end(), x, x + 3);
        }
    // a mesh has few triangles against the particles, and particles roam over all of it
    int count = static_cast<int>(mine.size()), ranks = 1;
    MPI_Comm_size(world, &ranks);
    std::vector<int> counts(static_cast<std::size_t>(ranks)), starts(static_cast<std::size_t>(ranks) + 1, 0);
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
    for (std::size_t r = 0; r < counts.size(); ++r)
        starts[r + 1] = starts[r] + counts[r];
    std::vector<double> all(static_cast<std::size_t>(starts.back()));
    MPI_Allgatherv(mine.data(), count, MPI_DOUBLE, all.data(), counts.data(), starts.data(), MPI_DOUBLE, world);

    std::vector<Triangle> triangles(all.size() / 9);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t corner = 0; corner < 3; ++corner)
            triangles[t][corner] = to_vector(&all[9 * t + 3 * corner]);
    return triangles;
}

}  // namespace interphase::walls
