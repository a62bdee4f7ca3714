// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/particle_state.hpp"

#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "atom.h"
#include "atom_vec.h"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "comm.h"
#include "domain.h"
#include "engines/liggghts/solids/random_numbers.hpp"
#include "fix.h"
#include "integrate.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"

namespace interphase {

namespace {

using LAMMPS_NS::Fix;
using LAMMPS_NS::LAMMPS;

constexpr int pushes = 6;                         ///< force and torque
constexpr int tag_place = 7, position_place = 1;  ///< of a particle that LIGGGHTS has packed (AtomVecSphere)

std::size_t at(int i) { return static_cast<std::size_t>(i); }

bool starts_with(const char* style, const char* start) { return std::strncmp(style, start, std::strlen(start)) == 0; }

/// A mesh at rest is as the script makes it; LIGGGHTS reads its state only while the script makes it.
bool has_own_state(const Fix& fix) { return fix.restart_global && !starts_with(fix.style, "mesh/"); }

/// What a fix writes for itself into a restart file, the same on all ranks. Collective.
std::vector<char> global_state(LAMMPS& lmp, Fix& fix)
{
    char* text = nullptr;
    std::size_t size = 0;
    FILE* stream = lmp.comm->me == 0 ? open_memstream(&text, &size) : nullptr;
    fix.write_restart(stream);
    std::vector<char> state;
    if (stream) {
        std::fclose(stream);
        constexpr std::size_t length = sizeof(int);  // what follows it is restart()'s
        if (size > length) state.assign(text + length, text + size);
        std::free(text);
    }
    auto bytes = static_cast<int>(state.size());
    MPI_Bcast(&bytes, 1, MPI_INT, 0, lmp.world);
    state.resize(at(bytes));
    MPI_Bcast(state.data(), bytes, MPI_BYTE, 0, lmp.world);
    return state;
}

/// Which fixes pack what of a particle, in this order.
std::string packers(const LAMMPS& lmp)
{
    std::string names;
    for (int n = 0; n < lmp.atom->nextra_grow; ++n) {
        const Fix& fix = *lmp.modify->fix[lmp.atom->extra_grow[n]];
        names += std::string(fix.id) + " (" + fix.style + "), ";
    }
    return names;
}

/// When it asks for neighbour lists next, which is when it acts; others leave that number as memory has it.
void keep_next_act(Archive& archive, Fix& fix)
{
    if (fix.force_reneighbor) archive.keep("next_reneighbor", fix.next_reneighbor);
}

void keep_fixes(LAMMPS& lmp, Archive& archive)
{
    for (int n = 0; n < lmp.modify->nfix; ++n) {
        Fix& fix = *lmp.modify->fix[n];
        archive.within(std::string("fix ") + fix.id, [&] {
            keep_next_act(archive, fix);
            if (!has_own_state(fix)) return;
            std::vector<char> state;
            if (!archive.loads()) state = global_state(lmp, fix);
            archive.keep("state", state);
            if (archive.loads() && !state.empty()) fix.restart(state.data());
        });
    }
}

std::vector<double> packed(LAMMPS& lmp)
{
    LAMMPS_NS::Atom& atom = *lmp.atom;
    // LIGGGHTS packs without a look at the room that there is; its own buffers have 1000 numbers to spare
    constexpr int spare = 10000;
    std::vector<double> buffer(at(lmp.comm->maxexchange_atom + lmp.comm->maxexchange_fix + spare)), all;
    for (int i = 0; i < atom.nlocal; ++i) {
        const int count = atom.avec->pack_exchange(i, buffer.data());
        all.insert(all.end(), buffer.begin(), buffer.begin() + count);
        all.insert(all.end(), atom.f[i], atom.f[i] + 3);
        all.insert(all.end(), atom.torque[i], atom.torque[i] + 3);
    }
    return all;
}

/// Who is where among the particles.
std::unordered_map<int, int> places(const LAMMPS_NS::Atom& atom)
{
    std::unordered_map<int, int> place;
    place.reserve(2 * at(atom.nlocal));
    for (int i = 0; i < atom.nlocal; ++i)
        place[atom.tag[i]] = i;
    return place;
}

/// Force and torque of a particle, on the way to whoever has it.
struct Push {
    double tag;
    double values[pushes];
};

int tag_of(double* record)
{
    Fix::ubuf number(record[tag_place]);
    return static_cast<int>(number.i);
}

void give(LAMMPS_NS::Atom& atom, int i, const double* push)
{
    std::copy_n(push, 3, atom.f[i]);
    std::copy_n(push + 3, 3, atom.torque[i]);
}

/// Sets forces and torques; those of particles that have gone to another rank follow them.
void give_pushes(LAMMPS& lmp, std::vector<double>& all)
{
    LAMMPS_NS::Atom& atom = *lmp.atom;
    const std::unordered_map<int, int> place = places(atom);
    std::vector<Push> gone;
    for (std::size_t k = 0; k < all.size();) {
        const auto count = static_cast<std::size_t>(all[k]);
        const int tag = tag_of(&all[k]);
        const auto here = place.find(tag);
        if (here != place.end())
            give(atom, here->second, &all[k + count]);
        else {
            gone.push_back({static_cast<double>(tag), {}});
            std::copy_n(&all[k + count], pushes, gone.back().values);
        }
        k += count + pushes;
    }
    int ranks = 1;
    MPI_Comm_size(lmp.world, &ranks);
    const int bytes = static_cast<int>(gone.size() * sizeof(Push));
    std::vector<int> sizes(at(ranks)), starts(at(ranks), 0);
    MPI_Allgather(&bytes, 1, MPI_INT, sizes.data(), 1, MPI_INT, lmp.world);
    for (std::size_t rank = 1; rank < sizes.size(); ++rank)
        starts[rank] = starts[rank - 1] + sizes[rank - 1];
    std::vector<Push> from_all(at(starts.back() + sizes.back()) / sizeof(Push));
    MPI_Allgatherv(gone.data(), bytes, MPI_BYTE, from_all.data(), sizes.data(), starts.data(), MPI_BYTE, lmp.world);
    for (const Push& push : from_all) {
        const auto here = place.find(static_cast<int>(push.tag));
        if (here != place.end()) give(atom, here->second, push.values);
    }
}

constexpr int shrinks = 2;  ///< from here on, of Domain::boundary: the side follows the particles

struct DomainBox {
    double low[3], high[3];
};

DomainBox box_of(const LAMMPS& lmp)
{
    DomainBox box;
    std::copy_n(lmp.domain->boxlo, 3, box.low);
    std::copy_n(lmp.domain->boxhi, 3, box.high);
    return box;
}

/// Where this rank's part of the box is among those of all ranks.
struct Cut {
    int parts[3], place[3];
};

Cut cut_of(const LAMMPS& lmp)
{
    Cut cut;
    std::copy_n(lmp.comm->procgrid, 3, cut.parts);
    std::copy_n(lmp.comm->myloc, 3, cut.place);
    return cut;
}

/// Whether a particle at `x` belongs to this rank. One that has left a periodic box counts where it comes in again, one
/// beyond a side that is fixed to the rank at that side: LIGGGHTS has not looked at it yet.
bool is_own(LAMMPS_NS::Domain& domain, const Cut& cut, const double* x)
{
    double at[3] = {x[0], x[1], x[2]};
    domain.remap(at);
    for (int axis = 0; axis < 3; ++axis) {
        const bool first = cut.place[axis] == 0, last = cut.place[axis] == cut.parts[axis] - 1;
        if ((!first && at[axis] < domain.sublo[axis]) || (!last && at[axis] >= domain.subhi[axis])) return false;
    }
    return true;
}

/// Of the particles of all ranks that saved, those of this rank's part of the box. Sides that follow the particles are
/// first put to where they were.
std::vector<double> sorted_anew(LAMMPS& lmp, const Archive& archive, const DomainBox& box, const std::string& script)
{
    LAMMPS_NS::Domain& domain = *lmp.domain;
    if (domain.triclinic || domain.is_wedge)
        throw UserError("the particles' domain is no upright box: its particles cannot go to other ranks", script,
                        "go on with " + std::to_string(archive.parts()) + " ranks");
    for (int axis = 0; axis < 3; ++axis) {
        if (domain.boundary[axis][0] >= shrinks) domain.boxlo[axis] = box.low[axis];
        if (domain.boundary[axis][1] >= shrinks) domain.boxhi[axis] = box.high[axis];
    }
    domain.set_global_box();
    domain.set_local_box();
    const Cut cut = cut_of(lmp);
    std::vector<double> own, pending;  // the latter of particles of which more is to come
    long saved = 0, numbers[2] = {0, 0};
    const auto sort = [&](const std::vector<char>& piece) {
        const std::size_t before = pending.size();
        pending.resize(before + piece.size() / sizeof(double));
        std::memcpy(&pending[before], piece.data(), piece.size());
        std::size_t k = 0;
        for (; k < pending.size(); ++saved) {
            const std::size_t count = static_cast<std::size_t>(pending[k]) + pushes;
            if (k + count > pending.size()) break;
            if (is_own(domain, cut, &pending[k + position_place])) {
                own.insert(own.end(), &pending[k], &pending[k] + count);
                ++numbers[0];
            }
            k += count;
        }
        pending.erase(pending.begin(), pending.begin() + static_cast<std::ptrdiff_t>(k));
    };
    constexpr std::size_t piece = sizeof(double) << 20;
    for (int part = 0; part < archive.parts(); ++part) {
        archive.part_in_pieces(part, "particles", piece, sort);
        if (!pending.empty()) throw std::runtime_error("a saved state ends within a particle");
    }
    MPI_Allreduce(&numbers[0], &numbers[1], 1, MPI_LONG, MPI_SUM, lmp.world);
    if (numbers[1] != saved)
        throw UserError("of the " + std::to_string(saved) + " particles of the checkpoint " +
                            std::to_string(numbers[1]) + " have a place on these ranks",
                        script, "go on with " + std::to_string(archive.parts()) + " ranks");
    return own;
}

/// This rank's particles of the state: its own, where ranks have the same parts of the box as those that saved.
std::vector<double> own_particles(LAMMPS& lmp, Archive& archive, const DomainBox& box, const std::string& script)
{
    int moved = !archive.same_ranks();
    if (!moved) {
        Cut then;
        archive.keep("cut", then);
        const Cut now = cut_of(lmp);
        moved = std::memcmp(&then, &now, sizeof now) != 0;
        MPI_Allreduce(MPI_IN_PLACE, &moved, 1, MPI_INT, MPI_MAX, lmp.world);
    }
    if (moved) return sorted_anew(lmp, archive, box, script);
    std::vector<double> all;
    archive.keep("particles", all);
    return all;
}

void replace_particles(LAMMPS& lmp, std::vector<double>& all)
{
    LAMMPS_NS::Atom& atom = *lmp.atom;
    // contact histories of those that go, now, and not from stale lists in setup_minimal()
    lmp.modify->setup_pre_exchange();
    if (atom.map_style) atom.map_clear();
    atom.nghost = 0;
    atom.nlocal = 0;
    for (std::size_t k = 0; k < all.size(); k += pushes)
        k += at(atom.avec->unpack_exchange(&all[k]));
    LAMMPS_NS::bigint here = atom.nlocal;
    MPI_Allreduce(&here, &atom.natoms, 1, MPI_LMP_BIGINT, MPI_SUM, lmp.world);
    if (atom.map_style) atom.map_init();
}

void refuse_other_box(const LAMMPS& lmp, const DomainBox& kept, const std::string& script)
{
    const DomainBox now = box_of(lmp);
    for (int axis = 0; axis < 3; ++axis) {
        const auto differs = [&](int side, double a, double b) {
            return lmp.domain->boundary[axis][side] < shrinks && a != b;
        };
        if (!differs(0, now.low[axis], kept.low[axis]) && !differs(1, now.high[axis], kept.high[axis])) continue;
        throw UserError("the particles' domain along " + std::string(1, "xyz"[axis]) + " is " + text(now.low[axis]) +
                            " to " + text(now.high[axis]) + " m, and was " + text(kept.low[axis]) + " to " +
                            text(kept.high[axis]) + " m when the checkpoint was written",
                        script, "go on with the script of the run");
    }
}

}  // namespace

void take_particle_state(LAMMPS& lmp, Archive& archive)
{
    lmp.modify->setup_pre_exchange();  // contact histories, from neighbour lists to particles
    std::string fixes = packers(lmp);
    std::vector<double> all = packed(lmp);
    DomainBox box = box_of(lmp);
    Cut cut = cut_of(lmp);
    archive.keep("step", lmp.update->ntimestep);
    archive.keep("packers", fixes);
    archive.keep("largest", lmp.comm->maxexchange_fix);
    archive.keep("box", box);
    archive.keep("cut", cut);
    archive.keep("particles", all);
    keep_fixes(lmp, archive);
}

void take_up_step(LAMMPS& lmp, Archive& archive)
{
    archive.keep("step", lmp.update->ntimestep);
    for (int n = 0; n < lmp.modify->nfix; ++n) {
        Fix& fix = *lmp.modify->fix[n];
        archive.within(std::string("fix ") + fix.id, [&] { keep_next_act(archive, fix); });
    }
}

void put_back_particle_state(LAMMPS& lmp, Archive& archive, const std::string& script)
{
    std::string fixes;
    archive.keep("packers", fixes);
    if (fixes != packers(lmp))
        throw UserError("the script's fixes with something for each particle are " + packers(lmp) +
                            "and those of the checkpoint " + fixes + "in this order",
                        script, "go on with the script and the plug-ins of the run");
    DomainBox box;
    int largest = 0;
    archive.keep("box", box);
    archive.keep_largest("largest", largest);
    std::vector<double> all = own_particles(lmp, archive, box, script);
    archive.keep("step", lmp.update->ntimestep);
    lmp.comm->maxexchange_fix = std::max(lmp.comm->maxexchange_fix, largest);

    replace_particles(lmp, all);
    keep_fixes(lmp, archive);
    seed_places(lmp);
    LAMMPS_NS::Atom& atom = *lmp.atom;
    if (atom.sortfreq > 0) atom.nextsort = (lmp.update->ntimestep / atom.sortfreq + 1) * atom.sortfreq;
    lmp.update->integrate->setup_minimal(1);
    give_pushes(lmp, all);
    refuse_other_box(lmp, box, script);
}

}  // namespace interphase
