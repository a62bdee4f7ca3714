// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/straight_paths.hpp"

namespace interphase {

namespace {

/// More faces than a sphere's radius crosses; a path that is still on its way then has been caught between faces that
/// do not quite meet, and ends where it is.
constexpr int most_faces = 200;

/// Of the way: faces as near to each other as that are reached together.
constexpr double tie = 1e-9;

constexpr std::size_t none = static_cast<std::size_t>(-1);

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

StraightPaths::StraightPaths(const MeshView& mesh, const CellSubdivision& subdivision)
    : subdivision_(subdivision), side_of_owner_(mesh.faces.size(), -1)
{
    std::vector<int> side_of_neighbour(mesh.faces.size(), -1);
    for (std::size_t c = 0; c < mesh.size(); ++c)
        for (std::size_t s = subdivision.sides_begin(c); s < subdivision.sides_end(c); ++s) {
            const std::size_t f = index(subdivision.side(s).face);
            (index(mesh.faces[f].owner) == c ? side_of_owner_ : side_of_neighbour)[f] = static_cast<int>(s);
            cell_of_side_.push_back(static_cast<int>(c));
        }
    beyond_.assign(cell_of_side_.size(), wall);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const MeshView::Face& face = mesh.faces[f];
        const std::size_t here = index(side_of_owner_[f]);
        if (face.neighbour >= 0) {
            beyond_[here] = side_of_neighbour[f];
            beyond_[index(side_of_neighbour[f])] = side_of_owner_[f];
        } else if (face.partner >= 0)
            beyond_[here] = other_rank;
    }
}

std::size_t StraightPaths::exit_of(const Path& path, double& share) const
{
    std::size_t exit = none;
    const auto beside = [&](std::size_t s, double t) {
        return subdivision_.aside(s, path.at + t * (path.to - path.at) - subdivision_.side(s).to_face);
    };
    share = 1;
    for (std::size_t s = subdivision_.sides_begin(index(path.cell)); s < subdivision_.sides_end(index(path.cell));
         ++s) {
        const Vector& gauge = subdivision_.side(s).gauge;
        const double from = gauge.dot(path.at), to = gauge.dot(path.to);
        if (!(to > 1) || !(to > from)) continue;
        const double t = std::max(0.0, (1 - from) / (to - from));
        if (exit != none && t > share + tie) continue;
        // several faces of a cell may lie in one plane
        if (exit != none && t > share - tie && beside(s, t) >= beside(exit, share)) continue;
        exit = s;
        share = t;
    }
    return exit;
}

int StraightPaths::follow(Path& path) const
{
    for (int n = 0; n < most_faces; ++n) {
        double share;
        const std::size_t exit = exit_of(path, share);
        if (exit == none) return -1;
        path.at += share * (path.to - path.at);
        const CellSubdivision::Side& side = subdivision_.side(exit);
        if (beyond_[exit] == wall) {
            path.to -= 2 * (side.gauge.dot(path.to) - 1) / side.gauge.squaredNorm() * side.gauge;
            continue;
        }
        path.at -= side.to_face;
        path.to -= side.to_face;
        if (beyond_[exit] == other_rank) return side.face;
        const std::size_t next = index(beyond_[exit]);
        path.at += subdivision_.side(next).to_face;
        path.to += subdivision_.side(next).to_face;
        path.cell = cell_of_side_[next];
    }
    path.to = path.at;
    return -1;
}

StraightPaths::Path StraightPaths::enter(int face, const Vector& at, const Vector& to) const
{
    const std::size_t side = index(side_of_owner_[index(face)]);
    const Vector& to_face = subdivision_.side(side).to_face;
    return {cell_of_side_[side], at + to_face, to + to_face};
}

}  // namespace interphase
