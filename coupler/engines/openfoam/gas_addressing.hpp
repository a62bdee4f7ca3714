// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fvMesh.H"

namespace interphase {

/// This rank's cells and faces by their numbers in the whole mesh, as decomposePar has left them (cellProcAddressing
/// and faceProcAddressing beside the part's mesh); on one rank they are their own.
class GasAddressing {
public:
    /// Collective.
    explicit GasAddressing(const Foam::fvMesh& mesh);

    /// Whether all ranks know the numbers.
    bool known() const { return known_; }

    /// Numbers of the cells [own cells].
    const std::vector<int>& cells() const { return cells_; }
    /// Number + 1 of the faces [own faces], negative where the face is turned round here.
    const std::vector<int>& faces() const { return faces_; }
    /// The first face of each patch, and the number of faces [own patches + 1]. Patches of the whole mesh come first
    /// and on all ranks, in one order; then those of cuts.
    const std::vector<int>& patch_starts() const { return patch_starts_; }
    /// Patches of the whole mesh.
    int patches() const { return patches_; }

private:
    bool known_ = false;
    std::vector<int> cells_, faces_, patch_starts_;
    int patches_ = 0;
};

}  // namespace interphase
