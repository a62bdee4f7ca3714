// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/mesh_part.hpp"

#include <algorithm>

#include "base/communicator.hpp"
#include "cyclicPolyPatch.H"
#include "engines/openfoam/mesh_faces.hpp"
#include "engines/openfoam/to_eigen.hpp"
#include "processorCyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "syncTools.H"
#include "treeDataCell.H"

namespace interphase {

namespace {

/// A particle moves by a cell or so between searches; a longer walk is a far jump, which the octree finds faster.
constexpr int longest_walk = 20;

}  // namespace

MeshPart::MeshPart(const Foam::fvMesh& mesh) : mesh_(mesh)
{
    measure_cells();
    for (const Foam::point& p : mesh_.points())
        view_.points.push_back(to_eigen(p));
    view_.faces = mesh_faces(mesh_);
    surfaces_.emplace(view_);
    find_ways_on();
    find_translations();
    plant_tree_of_edge();
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

void MeshPart::find_ways_on()
{
    const int me = Foam::UPstream::myProcNo();
    const Foam::label inner = mesh_.nInternalFaces();
    Foam::labelList cell_beyond(mesh_.nFaces() - inner, -1);
    forAll(cell_beyond, i) cell_beyond[i] = mesh_.faceOwner()[inner + i];
    Foam::syncTools::swapBoundaryFaceList(mesh_, cell_beyond);

    beyond_.resize(view_.faces.size());
    for (Foam::label f = 0; f < inner; ++f)
        beyond_[static_cast<std::size_t>(f)] = {me, mesh_.faceNeighbour()[f]};
    // A walk does not pass a cyclic pair, whether its halves are on one rank or on two: the point would not move along.
    for (const Foam::polyPatch& patch : mesh_.boundaryMesh()) {
        if (!Foam::isA<Foam::processorPolyPatch>(patch) || Foam::isA<Foam::processorCyclicPolyPatch>(patch)) continue;
        const int rank = Foam::refCast<const Foam::processorPolyPatch>(patch).neighbProcNo();
        for (Foam::label f = patch.start(); f < patch.start() + patch.size(); ++f)
            beyond_[static_cast<std::size_t>(f)] = {rank, cell_beyond[f - inner]};
    }
}

void MeshPart::find_translations()
{
    const Foam::label inner = mesh_.nInternalFaces();
    Foam::pointField beyond(mesh_.nFaces() - inner);
    forAll(beyond, i) beyond[i] = mesh_.faceCentres()[inner + i];
    Foam::syncTools::swapBoundaryFaceList(mesh_, beyond);  // as a list of numbers: the points are not moved along

    const double tie = 1e-6 * (bounds_.col(1) - bounds_.col(0)).norm();
    const auto add = [&](const Vector& translation) {
        const bool known = std::any_of(translations_.begin(), translations_.end(),
                                       [&](const Vector& other) { return (other - translation).norm() <= tie; });
        if (!known) translations_.push_back(translation);
    };
    for (const Foam::polyPatch& patch : mesh_.boundaryMesh())
        if (Foam::isA<Foam::cyclicPolyPatch>(patch) || Foam::isA<Foam::processorCyclicPolyPatch>(patch))
            for (Foam::label f = patch.start(); f < patch.start() + patch.size(); ++f)
                add(to_eigen(beyond[f - inner] - mesh_.faceCentres()[f]));
    Scalars mine;
    for (const Vector& translation : translations_)
        mine.insert(mine.end(), translation.begin(), translation.end());
    const Communicator ranks;
    mine.resize(static_cast<std::size_t>(ranks.max(static_cast<double>(mine.size()))), 0.0);
    const Scalars all = ranks.all_gather(mine);
    for (std::size_t i = 0; i < all.size(); i += 3)
        if (const Vector translation(all[i], all[i + 1], all[i + 2]); translation.norm() > tie) add(translation);
}

void MeshPart::plant_tree_of_edge()
{
    Foam::DynamicList<Foam::label> edge;
    for (const Foam::polyPatch& patch : mesh_.boundaryMesh())
        if (!patch.coupled())
            for (Foam::label f = patch.start(); f < patch.start() + patch.size(); ++f)
                edge.append(f);
    // faces in the box's own planes would be cut off by round-off
    Foam::treeBoundBox box(mesh_.points());
    box.inflate(0.01);
    edge_ = std::make_unique<Foam::indexedOctree<Foam::treeDataFace>>(Foam::treeDataFace(true, mesh_, edge), box, 8,
                                                                      10.0, 3.0);
}

CellAddress MeshPart::walk(const Vector& point, int start) const
{
    const int me = Foam::UPstream::myProcNo();
    int cell = start;
    for (int step = 0; step < longest_walk; ++step) {
        const auto here = static_cast<std::size_t>(cell);
        if (surfaces_->holds(point, here)) return {me, cell};
        const auto beyond = [&](const CellSurfaces::Side& side) -> CellAddress {
            const auto face = static_cast<std::size_t>(side.face);
            const CellAddress& next = beyond_[face];
            return next.rank == me && next.cell == cell ? CellAddress{me, view_.faces[face].owner} : next;
        };
        const CellSurfaces::Side* exit =
            surfaces_->way_out(point, here, [&](const CellSurfaces::Side& side) { return beyond(side).known(); });
        if (!exit) return {};  // only boundary faces are in the way
        const CellAddress next = beyond(*exit);
        if (next.rank != me) return next;
        cell = next.cell;
    }
    return {};
}

int MeshPart::cell_that_holds(const Vector& point) const
{
    const Foam::point p(point.x(), point.y(), point.z());
    const auto holds = [&](Foam::label cell) { return surfaces_->holds(point, static_cast<std::size_t>(cell)); };
    // OpenFOAM cuts warped faces otherwise, and what lies near one it may see in the next cell, or in none
    const Foam::label guess = mesh_.cellTree().findInside(p);
    if (guess >= 0 && holds(guess)) return guess;
    const Foam::labelList candidates = mesh_.cellTree().findBox(Foam::treeBoundBox(p, p));
    const Foam::label* found = std::find_if(candidates.begin(), candidates.end(), holds);
    return found == candidates.end() ? -1 : *found;
}

CellAddress MeshPart::search(const Vector& point) const
{
    if (!contains(bounds_, point)) return {};
    const int cell = cell_that_holds(point);
    return cell < 0 ? CellAddress{} : CellAddress{Foam::UPstream::myProcNo(), cell};
}

NearCell MeshPart::nearest(const Vector& point, double reach) const
{
    if (edge_->shapes().size() == 0) return {};
    const Foam::point from(point.x(), point.y(), point.z());
    const Foam::pointIndexHit hit = edge_->findNearest(from, reach * reach);
    if (!hit.hit()) return {};
    const Foam::label face = edge_->shapes().faceLabels()[hit.index()];
    return {static_cast<int>(mesh_.faceOwner()[face]), Foam::mag(hit.hitPoint() - from)};
}

}  // namespace interphase
