// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/mapped_spheres.hpp"

#include <numeric>

namespace interphase::test {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

void Spheres::add(const Vector& position, int cell, double volume)
{
    positions.push_back(position);
    cells.push_back(cell);
    volumes.push_back(volume);
}

double sphere_volume(double diameter) { return M_PI / 6 * diameter * diameter * diameter; }

MeshView whole_view(const WholeMesh& mesh)
{
    std::vector<int> number(mesh.cells);
    std::iota(number.begin(), number.end(), 0);
    return mesh.part(std::vector<int>(mesh.cells, 0), number, 0);
}

Spheres scattered(const WholeMesh& mesh, std::size_t count, const std::function<double(std::size_t)>& diameter,
                  unsigned seed)
{
    const MeshView view = whole_view(mesh);
    std::vector<std::vector<std::size_t>> faces_of(view.size());
    for (std::size_t f = 0; f < view.faces.size(); ++f) {
        faces_of[at(view.faces[f].owner)].push_back(f);
        if (view.faces[f].neighbour >= 0) faces_of[at(view.faces[f].neighbour)].push_back(f);
    }
    std::mt19937 random(seed);
    const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    Spheres spheres;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t cell = below(view.size());
        const MeshView::Face& face = view.faces[faces_of[cell][below(faces_of[cell].size())]];
        const std::size_t edge = below(face.points.size());
        const Vector corners[4] = {view.centre[cell], face.centre, view.points[at(face.points[edge])],
                                   view.points[at(face.points[(edge + 1) % face.points.size()])]};
        Vector position = Vector::Zero();
        double sum = 0;
        for (const Vector& corner : corners) {
            const double weight = std::exponential_distribution<double>()(random);  // even in the tetrahedron
            position += weight * corner;
            sum += weight;
        }
        spheres.add(position / sum, static_cast<int>(cell), sphere_volume(diameter(i)));
    }
    return spheres;
}

CellFinder::CellFinder(const MeshView& mesh) : planes_(mesh.size())
{
    for (const MeshView::Face& face : mesh.faces) {
        const Vector normal = face.area.normalized();
        planes_[at(face.owner)].push_back({normal, normal.dot(face.centre)});
        if (face.neighbour >= 0) planes_[at(face.neighbour)].push_back({-normal, -normal.dot(face.centre)});
    }
}

int CellFinder::cell_at(const Vector& point) const
{
    int best = -1;
    double farthest = -1e300;
    for (std::size_t c = 0; c < planes_.size(); ++c) {
        double behind = 1e300;
        for (const Plane& plane : planes_[c])
            behind = std::min(behind, plane.offset - plane.normal.dot(point));
        if (behind <= farthest) continue;
        farthest = behind;
        best = static_cast<int>(c);
    }
    return best;
}

Partition Partition::at_random(std::size_t cells, int ranks, unsigned seed)
{
    std::mt19937 random(seed);
    Partition partition;
    std::vector<int> count(at(ranks), 0);
    for (std::size_t c = 0; c < cells; ++c) {
        const int rank = std::uniform_int_distribution<int>(0, ranks - 1)(random);
        partition.rank_of.push_back(rank);
        partition.number_on.push_back(count[at(rank)]++);
    }
    return partition;
}

MappedSpheres::MappedSpheres(const Communicator& comm, const WholeMesh& mesh, const Spheres& spheres,
                             const MappingRules& rules, unsigned partition_seed)
    : comm_(comm),
      cells_(mesh.cells),
      spheres_(spheres.size()),
      volume_of_all_(spheres.volumes),
      partition_(Partition::at_random(mesh.cells, comm.size(), partition_seed)),
      view(mesh.part(partition_.rank_of, partition_.number_on, comm.rank())),
      mapping(comm, view, rules)
{
    for (std::size_t c = 0; c < cells_; ++c)
        if (partition_.rank_of[c] == comm.rank()) own_cells.push_back(c);
    Vectors positions;
    std::vector<int> cells;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const std::size_t cell = at(spheres.cells[i]);
        if (partition_.rank_of[cell] != comm.rank()) continue;
        here.push_back(i);
        positions.push_back(spheres.positions[i]);
        cells.push_back(partition_.number_on[cell]);
        volumes.push_back(spheres.volumes[i]);
    }
    mapping.place(positions, cells, volumes);
}

double MappedSpheres::dot(const Scalars& a, const Scalars& b) const
{
    return comm_.sum(std::inner_product(a.begin(), a.end(), b.begin(), 0.0));
}

Scalars MappedSpheres::everywhere(const Scalars& own, const std::vector<std::size_t>& numbers, std::size_t count) const
{
    Scalars all(count, 0.0);
    for (std::size_t i = 0; i < own.size(); ++i)
        all[numbers[i]] = own[i];
    comm_.sum(all);
    return all;
}

Scalars weights_of(const Communicator& comm, const WholeMesh& mesh, const Vector& position, int cell, double diameter,
                   const MappingRules& rules)
{
    Spheres one;
    one.add(position, cell, sphere_volume(diameter));
    const MappedSpheres p(comm, mesh, one, rules);
    return p.of_whole_mesh(p.mapping.deposit(Scalars(p.here.size(), 1.0)));
}

}  // namespace interphase::test
