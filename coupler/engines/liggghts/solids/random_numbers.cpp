// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/random_numbers.hpp"

#include <cstdint>

#include "comm.h"
#include "domain.h"
#include "fix_insert_stream.h"
#include "fix_massflow_mesh_sieve.h"
#include "fix_mesh.h"
#include "lammps.h"
#include "modify.h"
#include "multi_node_mesh.h"
#include "random_park.h"
#include "region.h"
#include "update.h"

namespace interphase {

namespace {

/// An explicit instantiation may name a private member.
template <class Name, typename Name::Member member>
struct Opened {
    friend typename Name::Member place_of(Name) { return member; }
};

struct RandomOfMesh {
    using Member = LAMMPS_NS::RanPark* LAMMPS_NS::MultiNodeMesh<3>::*;
    friend Member place_of(RandomOfMesh);
};
template struct Opened<RandomOfMesh, &LAMMPS_NS::MultiNodeMesh<3>::random_>;

/// What LIGGGHTS finds out once, by many random numbers of the face, at the first insertion of a program: to be found
/// out again.
struct Stream : LAMMPS_NS::FixInsertStream {
    static bool& begins(LAMMPS_NS::FixInsertStream& fix) { return fix.*(&Stream::do_ins_fraction_calc); }
};

/// What draws whether a particle passes.
struct Sieve : LAMMPS_NS::FixMassflowMeshSieve {
    static LAMMPS_NS::RanPark& random(LAMMPS_NS::FixMassflowMeshSieve& fix) { return *(fix.*(&Sieve::random_)); }
};

/// Another for each step, rank and thing, as LIGGGHTS's generator wants it.
int seed(const LAMMPS_NS::LAMMPS& lmp, int thing)
{
    constexpr std::int64_t largest = 2147483646;
    const std::int64_t mixed =
        (lmp.update->ntimestep + 1) * 48271 + std::int64_t{69621} * thing + std::int64_t{16807} * lmp.comm->me;
    return static_cast<int>(1 + mixed % largest);
}

}  // namespace

void seed_places(LAMMPS_NS::LAMMPS& lmp)
{
    int thing = 0;
    for (int n = 0; n < lmp.domain->nregion; ++n)
        lmp.domain->regions[n]->reset_random(seed(lmp, ++thing));
    for (int n = 0; n < lmp.modify->nfix; ++n) {
        if (auto* stream = dynamic_cast<LAMMPS_NS::FixInsertStream*>(lmp.modify->fix[n]))
            Stream::begins(*stream) = true;
        if (auto* sieve = dynamic_cast<LAMMPS_NS::FixMassflowMeshSieve*>(lmp.modify->fix[n]))
            Sieve::random(*sieve).reset(seed(lmp, ++thing));
        auto* fix = dynamic_cast<LAMMPS_NS::FixMesh*>(lmp.modify->fix[n]);
        if (!fix) continue;
        auto* mesh = dynamic_cast<LAMMPS_NS::MultiNodeMesh<3>*>(fix->mesh());
        if (mesh) (mesh->*place_of(RandomOfMesh{}))->reset(seed(lmp, ++thing));
    }
}

}  // namespace interphase
