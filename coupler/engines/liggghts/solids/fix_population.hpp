// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "engines/liggghts/solids/outlets.hpp"
#include "fix.h"
#include "step/departure.hpp"

namespace interphase {

class FixFluid;

/// The LIGGGHTS fix style `interphase/population`: knows which particles are made, deleted or dropped, and how.
///
/// LIGGGHTS deletes by fixes, before particles change rank, and drops what is in no rank's part of its box, as they do.
/// So this fix takes its turn before and after every fix that may delete, and sees each particle that is packed for
/// another rank and each that arrives. One that was packed and is nowhere was dropped. It acts on nothing but the
/// memory of outlets that did not see a particle come (Outlets).
class FixPopulation : public LAMMPS_NS::Fix {
public:
    static constexpr const char* style_name = "interphase/population";

    FixPopulation(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
    ~FixPopulation() override;

    /// `fluid`: the fix whose books departing particles take along, or null. After LIGGGHTS's init(). Collective.
    void watch(FixFluid* fluid);

    /// Others are there now than those that were, and nobody came or went.
    void begin_anew();

    /// Before the solids move.
    void begin();
    /// After: departures() and arrivals() are those in between, each departure on one rank. Collective.
    void settle();
    const std::vector<Departure>& departures() const { return departures_; }
    const std::vector<std::size_t>& arrivals() const { return arrivals_; }
    /// Particles that fixes massflow/mesh saw only after they had come through, of all ranks since watch().
    long seen_late() const { return seen_late_; }
    void count_seen_late(long number) { seen_late_ += number; }

    int setmask() override;
    void post_integrate() override;
    void pre_exchange() override;
    void grow_arrays(int count) override;
    void copy_arrays(int from, int to, int) override;
    void set_arrays(int i) override;
    int pack_exchange(int i, double* buffer) override;
    int unpack_exchange(int i, double* buffer) override;

private:
    /// One that was packed for other ranks.
    struct Packed {
        Departure as_it_was;
        int hops;  ///< how often since the solids began to move, this time included
    };

    Departure as_it_is(int i, Exit exit) const;
    void remember_all();
    void find_deleted(Exit exit);
    void find_dropped();
    long sum(long mine) const;

    FixFluid* fluid_ = nullptr;
    std::vector<int> is_new_, hops_;  ///< of each particle
    std::vector<Exit> watched_;       ///< of the fixes that may delete, each between two turns of this one
    std::unique_ptr<Outlets> outlets_;
    std::size_t turn_ = 0;
    LAMMPS_NS::bigint last_step_ = -1;
    std::vector<Departure> remembered_;
    std::vector<Packed> packed_;
    std::vector<Departure> departures_;
    std::vector<std::size_t> arrivals_;
    long made_ = 0, late_ = 0;        ///< on this rank since begin()
    long count_ = 0, seen_late_ = 0;  ///< of all ranks at the last settle()
};

}  // namespace interphase
