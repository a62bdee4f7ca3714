// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/mesh_faces.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "base/communicator.hpp"
#include "base/problem.hpp"
#include "base/text.hpp"
#include "cyclicPolyPatch.H"
#include "engines/openfoam/to_eigen.hpp"
#include "processorPolyPatch.H"
#include "syncTools.H"

namespace interphase {

namespace {

using Foam::coupledPolyPatch;
using Foam::polyPatch;

Problem unmatched(const polyPatch& patch, const std::string& why)
{
    return {"the patch `" + std::string(patch.name()) + "` of type " + std::string(patch.type()) + " " + why +
                ", and particles are mapped through pairs of equal faces only",
            "constant/polyMesh/boundary",
            "make it a pair of type cyclic with `transform translational;` whose halves have the same faces, or join "
            "the meshes (stitchMesh)"};
}

/// Of the types of patches, which every rank knows of all of them.
std::optional<Problem> wrong_type(const Foam::polyBoundaryMesh& patches)
{
    for (const polyPatch& patch : patches) {
        const auto* coupled =
            Foam::isA<coupledPolyPatch>(patch) ? &Foam::refCast<const coupledPolyPatch>(patch) : nullptr;
        if (!coupled || Foam::isA<Foam::processorPolyPatch>(patch)) continue;
        // types made from cyclic are other things: a wall that slips, a turn that differs from face to face
        if (patch.type() != Foam::cyclicPolyPatch::typeName)
            return unmatched(patch, "joins cells that do not share whole faces, or turns what passes it");
        if (!coupled->parallel()) return unmatched(patch, "turns what passes it");
    }
    return std::nullopt;
}

/// Gives the two halves of a face the same first corner. OpenFOAM's tools write them so, but nothing in it demands
/// that of cyclic patches. The half that does not own the pair follows.
std::optional<Problem> begin_alike(const Foam::fvMesh& mesh, std::vector<MeshView::Face>& faces)
{
    const Foam::label inner = mesh.nInternalFaces();
    Foam::pointField first_beyond(mesh.nFaces() - inner);
    Foam::labelList corners_beyond(first_beyond.size());
    forAll(first_beyond, i)
    {
        first_beyond[i] = mesh.points()[mesh.faces()[inner + i][0]];
        corners_beyond[i] = mesh.faces()[inner + i].size();
    }
    Foam::syncTools::swapBoundaryFacePositions(mesh, first_beyond);
    Foam::syncTools::swapBoundaryFaceList(mesh, corners_beyond);

    for (const polyPatch& patch : mesh.boundaryMesh()) {
        if (!Foam::isA<coupledPolyPatch>(patch)) continue;
        const bool follows = Foam::refCast<const coupledPolyPatch>(patch).neighbour();
        for (Foam::label f = patch.start(); f < patch.start() + patch.size(); ++f) {
            std::vector<int>& corners = faces[static_cast<std::size_t>(f)].points;
            if (corners_beyond[f - inner] != static_cast<Foam::label>(corners.size()))
                return unmatched(patch, "has a face with " + std::to_string(corners.size()) + " corners at " +
                                            text(to_eigen(mesh.faceCentres()[f])) + " that has " +
                                            std::to_string(corners_beyond[f - inner]) + " on the other side");
            if (!follows) continue;
            const Foam::point& first = first_beyond[f - inner];
            const auto distance = [&](int p) { return Foam::magSqr(mesh.points()[p] - first); };
            std::rotate(corners.begin(),
                        std::min_element(corners.begin(), corners.end(),
                                         [&](int a, int b) { return distance(a) < distance(b); }),
                        corners.end());
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<MeshView::Face> mesh_faces(const Foam::fvMesh& mesh)
{
    const Communicator ranks;
    ranks.fail_together(wrong_type(mesh.boundaryMesh()));

    std::vector<MeshView::Face> faces(static_cast<std::size_t>(mesh.nFaces()));
    forAll(mesh.faces(), f)
    {
        MeshView::Face& face = faces[static_cast<std::size_t>(f)];
        face.centre = to_eigen(mesh.faceCentres()[f]);
        face.area = to_eigen(mesh.faceAreas()[f]);
        face.points.assign(mesh.faces()[f].begin(), mesh.faces()[f].end());
        face.owner = mesh.faceOwner()[f];
        if (mesh.isInternalFace(f)) face.neighbour = mesh.faceNeighbour()[f];
    }

    const Foam::label inner = mesh.nInternalFaces();
    Foam::labelList number_beyond(mesh.nFaces() - inner);
    forAll(number_beyond, i) number_beyond[i] = inner + i;
    Foam::syncTools::swapBoundaryFaceList(mesh, number_beyond);
    for (const polyPatch& patch : mesh.boundaryMesh()) {
        if (!Foam::isA<coupledPolyPatch>(patch)) continue;
        const int rank = Foam::isA<Foam::processorPolyPatch>(patch)
                             ? Foam::refCast<const Foam::processorPolyPatch>(patch).neighbProcNo()
                             : Foam::UPstream::myProcNo();
        for (Foam::label f = patch.start(); f < patch.start() + patch.size(); ++f) {
            faces[static_cast<std::size_t>(f)].partner_rank = rank;
            faces[static_cast<std::size_t>(f)].partner = number_beyond[f - inner];
        }
    }
    ranks.fail_together(begin_alike(mesh, faces));
    return faces;
}

}  // namespace interphase
