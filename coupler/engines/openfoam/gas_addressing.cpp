// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/gas_addressing.hpp"

#include <numeric>

#include "labelIOList.H"
#include "processorPolyPatch.H"

namespace interphase {

using namespace Foam;

namespace {

std::vector<int> read_list(const fvMesh& mesh, const char* name)
{
    const labelIOList list(IOobject(name, mesh.facesInstance(), polyMesh::meshSubDir, mesh, IOobject::READ_IF_PRESENT,
                                    IOobject::NO_WRITE, false));
    return {list.begin(), list.end()};
}

}  // namespace

GasAddressing::GasAddressing(const fvMesh& mesh)
{
    for (const polyPatch& patch : mesh.boundaryMesh()) {
        patch_starts_.push_back(patch.start());
        patches_ += !isA<processorPolyPatch>(patch);
    }
    patch_starts_.push_back(mesh.nFaces());
    if (UPstream::parRun()) {
        cells_ = read_list(mesh, "cellProcAddressing");
        faces_ = read_list(mesh, "faceProcAddressing");
    } else {
        cells_.resize(static_cast<std::size_t>(mesh.nCells()));
        faces_.resize(static_cast<std::size_t>(mesh.nFaces()));
        std::iota(cells_.begin(), cells_.end(), 0);
        std::iota(faces_.begin(), faces_.end(), 1);
    }
    known_ = returnReduce(cells_.size() == static_cast<std::size_t>(mesh.nCells()) &&
                              faces_.size() == static_cast<std::size_t>(mesh.nFaces()),
                          andOp<bool>());
}

}  // namespace interphase
