// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/mesh_part.hpp"

#include "engines/openfoam/mesh_faces.hpp"
#include "indexedOctree.H"
#include "syncTools.H"
#include "treeDataCell.H"

namespace interphase {

namespace {

/// A particle moves by a cell or so between searches; a longer walk is a far jump, which the octree finds faster.
constexpr int longest_walk = 20;

Vector to_eigen(const Foam::point& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

MeshPart::MeshPart(const Foam::fvMesh& mesh) : mesh_(mesh)
{
    measure_cells();
    for (const Foam::point& p : mesh_.points())
        view_.points.push_back(to_eigen(p));
    view_.faces = mesh_faces(mesh_);
    collect_sides();
    // what a search needs OpenFOAM builds on demand, with all ranks taking part: now, not when one of them searches
    mesh_.tetBasePtIs();
    mesh_.cellTree();
}

void MeshPart::measure_cells()
{
    const auto& points_of_cells = mesh_.cellPoints();
    forAll(mesh_.cells(), c)
    {
        Box box = empty_box();
        for (const Foam::label p : points_of_cells[c])
            extend(box, to_eigen(mesh_.points()[p]));
        view_.centre.push_back(to_eigen(mesh_.cellCentres()[c]));
        view_.extent.push_back(box.col(1) - box.col(0));
        view_.volume.push_back(mesh_.cellVolumes()[c]);
        extend(bounds_, box.col(0));
        extend(bounds_, box.col(1));
    }
}

void MeshPart::collect_sides()
{
    const int me = Foam::UPstream::myProcNo();
    const Foam::label inner = mesh_.nInternalFaces();

    Foam::labelList cell_beyond(mesh_.nFaces() - inner, -1);
    forAll(cell_beyond, i) cell_beyond[i] = mesh_.faceOwner()[inner + i];
    Foam::syncTools::swapBoundaryFaceList(mesh_, cell_beyond);
    // A particle does not walk through a cyclic pair.
    const auto address_beyond = [&](Foam::label face) -> CellAddress {
        const int rank = view_.faces[static_cast<std::size_t>(face)].partner_rank;
        return rank >= 0 && rank != me ? CellAddress{rank, cell_beyond[face - inner]} : CellAddress{};
    };

    first_side_.assign(1, 0);
    forAll(mesh_.cells(), c)
    {
        for (const Foam::label face : mesh_.cells()[c]) {
            const bool owned = mesh_.faceOwner()[face] == c;
            const Vector outward = (owned ? 1 : -1) * to_eigen(mesh_.faceAreas()[face]).normalized();
            CellAddress beyond;
            if (face < inner)
                beyond = {me, owned ? mesh_.faceNeighbour()[face] : mesh_.faceOwner()[face]};
            else
                beyond = address_beyond(face);
            sides_.push_back({outward, outward.dot(to_eigen(mesh_.faceCentres()[face])), beyond});
        }
        first_side_.push_back(sides_.size());
    }
}

CellAddress MeshPart::walk(const Vector& point, int start) const
{
    const int me = Foam::UPstream::myProcNo();
    CellAddress at{me, start};
    for (int step = 0; step < longest_walk; ++step) {
        const auto cell = static_cast<std::size_t>(at.cell);
        double farthest = 0;
        const Side* exit = nullptr;
        bool outside = false;
        for (std::size_t s = first_side_[cell]; s < first_side_[cell + 1]; ++s) {
            const double distance = sides_[s].distance(point);
            if (distance <= 0) continue;
            outside = true;
            if (distance > farthest && sides_[s].beyond.known()) {
                farthest = distance;
                exit = &sides_[s];
            }
        }
        if (!outside) return at;
        if (!exit) return {};  // only boundary faces are in the way
        if (exit->beyond.rank != me) return exit->beyond;
        at = exit->beyond;
    }
    return {};
}

CellAddress MeshPart::search(const Vector& point) const
{
    if (!contains(bounds_, point)) return {};
    const Foam::label cell = mesh_.cellTree().findInside(Foam::point(point.x(), point.y(), point.z()));
    return cell < 0 ? CellAddress{} : CellAddress{Foam::UPstream::myProcNo(), cell};
}

}  // namespace interphase
