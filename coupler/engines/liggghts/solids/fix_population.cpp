// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/fix_population.hpp"

#include <mpi.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "atom.h"
#include "engines/liggghts/solids/fix_fluid.hpp"
#include "lammps.h"
#include "modify.h"
#include "update.h"

namespace interphase {

namespace {

constexpr int grow_callback = 0;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// The order in which LIGGGHTS calls fixes before particles change rank, which it gives nobody to change.
struct CallsBeforeExchange : LAMMPS_NS::Modify {
    static int*& list(LAMMPS_NS::Modify& modify) { return modify.*(&CallsBeforeExchange::list_pre_exchange); }
};

bool starts_with(const char* style, const char* start) { return std::strncmp(style, start, std::strlen(start)) == 0; }

/// Styles of LIGGGHTS that are called there and delete nothing.
bool only_keeps_or_inserts(const LAMMPS_NS::Fix& fix)
{
    constexpr const char* harmless[] = {"contacthistory", "contactproperty", "insert/",
                                        "mesh/",          "neighlist/mesh",  "property/"};
    return std::any_of(std::begin(harmless), std::end(harmless),
                       [&](const char* start) { return starts_with(fix.style, start); });
}

}  // namespace

FixPopulation::FixPopulation(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg)
{
    create_attribute = 1;
    grow_arrays(atom->nmax);
    atom->add_callback(grow_callback);
}

FixPopulation::~FixPopulation() { atom->delete_callback(id, grow_callback); }

int FixPopulation::setmask() { return LAMMPS_NS::FixConst::POST_INTEGRATE | LAMMPS_NS::FixConst::PRE_EXCHANGE; }

void FixPopulation::watch(FixFluid* fluid)
{
    fluid_ = fluid;
    outlets_ = std::make_unique<Outlets>(*lmp);
    count_ = sum(atom->nlocal);
    made_ = late_ = 0;

    int*& list = CallsBeforeExchange::list(*modify);
    std::vector<int> order;
    int own = 0;
    for (int n = 0; n < modify->n_pre_exchange; ++n) {
        const LAMMPS_NS::Fix& fix = *modify->fix[list[n]];
        if (&fix == this)
            own = list[n];
        else
            order.push_back(list[n]);
    }
    std::vector<int> with_turns;
    watched_.clear();
    for (const int n : order) {
        const LAMMPS_NS::Fix& fix = *modify->fix[n];
        if (only_keeps_or_inserts(fix)) {
            with_turns.push_back(n);
            continue;
        }
        with_turns.insert(with_turns.end(), {own, n, own});
        watched_.push_back(starts_with(fix.style, "massflow/mesh") ? Exit::mesh : Exit::script);
    }
    delete[] list;
    list = new int[with_turns.size()];
    std::copy(with_turns.begin(), with_turns.end(), list);
    modify->n_pre_exchange = static_cast<int>(with_turns.size());
}

void FixPopulation::begin_anew()
{
    begin();
    count_ = sum(atom->nlocal);
    last_step_ = -1;
    turn_ = 0;
}

void FixPopulation::begin()
{
    departures_.clear();
    arrivals_.clear();
    packed_.clear();
    made_ = late_ = 0;
    std::fill(is_new_.begin(), is_new_.end(), 0);
    std::fill(hops_.begin(), hops_.end(), 0);
}

void FixPopulation::post_integrate()
{
    if (outlets_) late_ += outlets_->correct(*lmp);
}

void FixPopulation::pre_exchange()
{
    if (last_step_ != update->ntimestep) turn_ = 0;
    last_step_ = update->ntimestep;
    if (turn_ % 2 == 0)
        remember_all();
    else
        find_deleted(watched_.at(turn_ / 2));
    ++turn_;
}

Departure FixPopulation::as_it_is(int i, Exit exit) const
{
    Departure departure{};
    departure.exit = exit;
    departure.is_new = is_new_[index(i)] != 0;
    departure.id = atom->tag[i];
    std::copy_n(atom->x[i], 3, departure.position);
    std::copy_n(atom->v[i], 3, departure.velocity);
    departure.mass = atom->rmass[i];
    departure.radius = atom->radius[i];
    if (fluid_) {
        std::copy_n(fluid_->booked() + 3 * i, 3, departure.booked);
        departure.coupling = fluid_->coupling()[i];
    }
    return departure;
}

void FixPopulation::remember_all()
{
    remembered_.clear();
    remembered_.reserve(index(atom->nlocal));
    for (int i = 0; i < atom->nlocal; ++i)
        remembered_.push_back(as_it_is(i, Exit::script));
}

void FixPopulation::find_deleted(Exit exit)
{
    if (index(atom->nlocal) == remembered_.size()) return;
    std::unordered_set<int> there;  // of those that are not where they were
    for (int i = 0; i < atom->nlocal; ++i)
        if (atom->tag[i] != remembered_[index(i)].id) there.insert(atom->tag[i]);
    for (std::size_t i = 0; i < remembered_.size(); ++i) {
        const bool in_place = i < index(atom->nlocal) && atom->tag[i] == remembered_[i].id;
        if (in_place || there.count(remembered_[i].id) > 0) continue;
        departures_.push_back(remembered_[i]);
        departures_.back().exit = exit;
    }
}

void FixPopulation::settle()
{
    for (int i = 0; i < atom->nlocal; ++i)
        if (is_new_[index(i)]) arrivals_.push_back(index(i));
    const long there = atom->nlocal, deleted = static_cast<long>(departures_.size());
    long numbers[4] = {there, made_, deleted, late_};
    MPI_Allreduce(MPI_IN_PLACE, numbers, 4, MPI_LONG, MPI_SUM, world);
    const long dropped = count_ + numbers[1] - numbers[2] - numbers[0];
    if (dropped > 0) find_dropped();
    count_ = numbers[0];
    seen_late_ += numbers[3];
}

void FixPopulation::find_dropped()
{
    // Packed, and not here now: somewhere else, deleted there, or nowhere.
    struct Candidate {
        int id, hops;
    };
    std::unordered_map<int, std::size_t> here;  // the last time that it was packed here
    std::unordered_set<int> seen;
    for (int i = 0; i < atom->nlocal; ++i)
        seen.insert(atom->tag[i]);
    for (const Departure& departure : departures_)
        seen.insert(departure.id);
    for (std::size_t n = 0; n < packed_.size(); ++n)
        if (seen.count(packed_[n].as_it_was.id) == 0) here[packed_[n].as_it_was.id] = n;
    std::vector<Candidate> mine;
    for (const auto& [id, n] : here)
        mine.push_back({id, packed_[n].hops});

    int ranks = 1;
    MPI_Comm_size(world, &ranks);
    const int bytes = static_cast<int>(mine.size() * sizeof(Candidate));
    std::vector<int> sizes(index(ranks)), starts(index(ranks), 0);
    MPI_Allgather(&bytes, 1, MPI_INT, sizes.data(), 1, MPI_INT, world);
    for (std::size_t rank = 1; rank < sizes.size(); ++rank)
        starts[rank] = starts[rank - 1] + sizes[rank - 1];
    std::vector<Candidate> all(index(starts.back() + sizes.back()) / sizeof(Candidate));
    MPI_Allgatherv(mine.data(), bytes, MPI_BYTE, all.data(), sizes.data(), starts.data(), MPI_BYTE, world);

    std::vector<int> found(all.size());
    for (std::size_t n = 0; n < all.size(); ++n)
        found[n] = seen.count(all[n].id) > 0;
    MPI_Allreduce(MPI_IN_PLACE, found.data(), static_cast<int>(found.size()), MPI_INT, MPI_MAX, world);
    for (std::size_t n = 0; n < all.size(); ++n) {
        const auto own = here.find(all[n].id);
        if (own == here.end()) continue;
        // another rank packed it later
        if (found[n] || all[n].hops > packed_[own->second].hops) here.erase(own);
    }
    for (const auto& [id, n] : here) {
        departures_.push_back(packed_[n].as_it_was);
        departures_.back().exit = Exit::boundary;
    }
}

long FixPopulation::sum(long mine) const
{
    long all = 0;
    MPI_Allreduce(&mine, &all, 1, MPI_LONG, MPI_SUM, world);
    return all;
}

void FixPopulation::grow_arrays(int count)
{
    is_new_.resize(index(count), 0);
    hops_.resize(index(count), 0);
}

void FixPopulation::copy_arrays(int from, int to, int)
{
    is_new_[index(to)] = is_new_[index(from)];
    hops_[index(to)] = hops_[index(from)];
}

void FixPopulation::set_arrays(int i)
{
    is_new_[index(i)] = 1;
    hops_[index(i)] = 0;
    ++made_;
}

int FixPopulation::pack_exchange(int i, double* buffer)
{
    const int hops = hops_[index(i)] + 1;
    packed_.push_back({as_it_is(i, Exit::boundary), hops});
    buffer[0] = is_new_[index(i)];
    buffer[1] = hops;
    return 2;
}

int FixPopulation::unpack_exchange(int i, double* buffer)
{
    is_new_[index(i)] = static_cast<int>(buffer[0]);
    hops_[index(i)] = static_cast<int>(buffer[1]);
    return 2;
}

}  // namespace interphase
