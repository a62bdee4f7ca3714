// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace LAMMPS_NS {
class FixMassflowMesh;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace interphase {

/// The fixes massflow/mesh of a script that count a particle once, and delete it or not.
///
/// LIGGGHTS counts a particle that was listed by the mesh on its near side and is on its far side now. It lists those
/// whose surface is within half a skin of the mesh, anew when one has moved by half a skin. So a particle that moves by
/// more than half a radius in a solid step may be beyond the mesh when it is listed first: it counts as one that has
/// always been there, and is neither counted nor deleted.
class Outlets {
public:
    explicit Outlets(const LAMMPS_NS::LAMMPS& lmp);

    /// After particles moved and the fixes looked at them: a particle that came through a mesh in this step unseen is
    /// given out as one from the near side, so that LIGGGHTS takes it in the next step. Returns how many of this rank.
    long correct(const LAMMPS_NS::LAMMPS& lmp) const;

private:
    std::vector<LAMMPS_NS::FixMassflowMesh*> outlets_;
};

}  // namespace interphase
