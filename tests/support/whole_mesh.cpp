// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/whole_mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace interphase::test {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Centre and area vector of a polygon, from triangles about the mean of its corners.
void measure(const Vectors& points, MeshView::Face& face)
{
    Vector mean = Vector::Zero();
    for (const int p : face.points)
        mean += points[at(p)] / static_cast<double>(face.points.size());
    face.area = face.centre = Vector::Zero();
    double sum = 0;
    for (std::size_t k = 0; k < face.points.size(); ++k) {
        const Vector a = points[at(face.points[k])], b = points[at(face.points[(k + 1) % face.points.size()])];
        const Vector area = 0.5 * (a - mean).cross(b - mean);
        face.area += area;
        face.centre += area.norm() * (a + b + mean) / 3;
        sum += area.norm();
    }
    face.centre /= sum;
}

/// Centres, volumes and extents of cells, from pyramids on their faces.
void measure(MeshView& mesh, std::size_t cells)
{
    mesh.centre.assign(cells, Vector::Zero());
    mesh.volume.assign(cells, 0.0);
    Vectors mean(cells, Vector::Zero());
    std::vector<int> faces(cells, 0);
    std::vector<Box> boxes(cells, empty_box());
    const auto for_each_side = [&](auto&& visit) {
        for (const MeshView::Face& face : mesh.faces) {
            visit(face, at(face.owner), 1.0);
            if (face.neighbour >= 0) visit(face, at(face.neighbour), -1.0);
        }
    };
    for_each_side([&](const MeshView::Face& face, std::size_t c, double) {
        mean[c] += face.centre;
        ++faces[c];
        for (const int p : face.points)
            extend(boxes[c], mesh.points[at(p)]);
    });
    for_each_side([&](const MeshView::Face& face, std::size_t c, double sign) {
        const Vector apex = mean[c] / faces[c];
        const double volume = sign * face.area.dot(face.centre - apex) / 3;
        mesh.volume[c] += volume;
        mesh.centre[c] += volume * (0.75 * face.centre + 0.25 * apex);
    });
    for (std::size_t c = 0; c < cells; ++c) {
        mesh.centre[c] /= mesh.volume[c];
        mesh.extent.push_back(boxes[c].col(1) - boxes[c].col(0));
    }
}

}  // namespace

WholeMesh WholeMesh::of_cells(Vectors points, const std::vector<std::vector<std::vector<int>>>& cells)
{
    WholeMesh mesh;
    mesh.points = std::move(points);
    mesh.cells = cells.size();
    std::map<std::vector<int>, std::size_t> found;
    for (std::size_t c = 0; c < cells.size(); ++c)
        for (const std::vector<int>& face : cells[c]) {
            std::vector<int> key = face;
            std::sort(key.begin(), key.end());
            const auto [place, is_new] = found.emplace(key, mesh.faces.size());
            if (is_new)
                mesh.faces.push_back({face, static_cast<int>(c)});
            else
                mesh.faces[place->second].neighbour = static_cast<int>(c);
        }
    return mesh;
}

WholeMesh WholeMesh::of_boxes(const std::array<Scalars, 3>& planes, const std::array<bool, 3>& periodic)
{
    const std::array<int, 3> n{static_cast<int>(planes[0].size()), static_cast<int>(planes[1].size()),
                               static_cast<int>(planes[2].size())};
    Vectors points;
    for (int k = 0; k < n[2]; ++k)
        for (int j = 0; j < n[1]; ++j)
            for (int i = 0; i < n[0]; ++i)
                points.emplace_back(planes[0][at(i)], planes[1][at(j)], planes[2][at(k)]);
    std::vector<std::vector<std::vector<int>>> cells;
    for (int k = 0; k + 1 < n[2]; ++k)
        for (int j = 0; j + 1 < n[1]; ++j)
            for (int i = 0; i + 1 < n[0]; ++i) {
                const auto p = [&](int a, int b, int c) { return i + a + n[0] * (j + b + n[1] * (k + c)); };
                cells.push_back({{p(0, 0, 0), p(0, 0, 1), p(0, 1, 1), p(0, 1, 0)},
                                 {p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), p(1, 0, 1)},
                                 {p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1)},
                                 {p(0, 1, 0), p(0, 1, 1), p(1, 1, 1), p(1, 1, 0)},
                                 {p(0, 0, 0), p(0, 1, 0), p(1, 1, 0), p(1, 0, 0)},
                                 {p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1)}});
            }
    WholeMesh mesh = of_cells(std::move(points), cells);
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (periodic[axis])
            mesh.glue_sides(Vector::Unit(static_cast<Eigen::Index>(axis)) *
                            (planes[axis].back() - planes[axis].front()));
    return mesh;
}

void WholeMesh::glue_sides(const Vector& shift)
{
    const double near = 1e-9 * shift.norm();
    const auto image = [&](int p, const Face& of) -> int {
        for (std::size_t k = 0; k < of.points.size(); ++k)
            if ((points[at(of.points[k])] - points[at(p)] - shift).norm() < near) return static_cast<int>(k);
        return -1;
    };
    std::vector<std::size_t> boundary;
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (faces[f].neighbour < 0 && faces[f].twin < 0) boundary.push_back(f);
    for (const std::size_t f : boundary)
        for (const std::size_t g : boundary) {
            Face &here = faces[f], &there = faces[g];
            if (f == g || here.points.size() != there.points.size()) continue;
            if (std::any_of(here.points.begin(), here.points.end(), [&](int p) { return image(p, there) < 0; }))
                continue;
            std::rotate(there.points.begin(), there.points.begin() + image(here.points[0], there), there.points.end());
            here.twin = static_cast<int>(g);
            there.twin = static_cast<int>(f);
        }
}

MeshView WholeMesh::part(const std::vector<int>& rank_of, const std::vector<int>& number_on, int rank) const
{
    // Each rank numbers the faces that it has in their order here; of a face cut in two, both halves stand there once.
    std::vector<std::array<int, 2>> number(faces.size(), {-1, -1});  // on the owner's rank, on the neighbour's
    std::map<int, int> count;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const int owner = rank_of[at(faces[f].owner)];
        number[f][0] = count[owner]++;
        if (faces[f].neighbour < 0) continue;
        const int neighbour = rank_of[at(faces[f].neighbour)];
        number[f][1] = neighbour == owner ? number[f][0] : count[neighbour]++;
    }

    MeshView view;
    view.points = points;
    std::size_t cells_here = 0;
    for (std::size_t c = 0; c < cells; ++c)
        cells_here += rank_of[c] == rank;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const Face& whole = faces[f];
        const int owner_rank = rank_of[at(whole.owner)];
        const int neighbour_rank = whole.neighbour < 0 ? -1 : rank_of[at(whole.neighbour)];
        if (owner_rank != rank && neighbour_rank != rank) continue;
        MeshView::Face face;
        face.points = whole.points;
        measure(points, face);
        if (owner_rank == rank) {
            face.owner = number_on[at(whole.owner)];
            if (neighbour_rank == rank)
                face.neighbour = number_on[at(whole.neighbour)];
            else if (whole.neighbour >= 0) {
                face.partner_rank = neighbour_rank;
                face.partner = number[f][1];
            } else if (whole.twin >= 0) {
                face.partner_rank = rank_of[at(faces[at(whole.twin)].owner)];
                face.partner = number[at(whole.twin)][0];
            }
        } else {
            face.owner = number_on[at(whole.neighbour)];
            face.area = -face.area;
            std::reverse(face.points.begin() + 1, face.points.end());
            face.partner_rank = owner_rank;
            face.partner = number[f][0];
        }
        view.faces.push_back(std::move(face));
    }
    measure(view, cells_here);
    return view;
}

}  // namespace interphase::test
