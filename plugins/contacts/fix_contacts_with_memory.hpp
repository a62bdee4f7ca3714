// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <unordered_map>

#include "contacts/contact_memory.hpp"
#include "contacts/exchange_room.hpp"
#include "contacts/fix_contacts.hpp"

namespace interphase::contacts {

/// A FixContacts whose law remembers a `State` (numbers and arrays of numbers; State{} is a contact that begins) for
/// each contact while it lasts. The states travel with the spheres between ranks, stand in checkpoints and in
/// LIGGGHTS's restart files, go with removed spheres, and follow those whose ids are given anew (delete_atoms).
template <class State>
class FixContactsWithMemory : public FixContacts {
public:
    FixContactsWithMemory(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg, const char* wall_style)
        : FixContacts(lmp, narg, arg, wall_style)
    {
        create_attribute = 1;
        restart_peratom = 1;
        FixContactsWithMemory::grow_arrays(atom->nmax);
        atom->add_callback(exchanged);
        atom->add_callback(restarted);
    }
    ~FixContactsWithMemory() override
    {
        atom->delete_callback(id, exchanged);
        atom->delete_callback(id, restarted);
    }

    int setmask() override { return FixContacts::setmask() | LAMMPS_NS::FixConst::PRE_EXCHANGE; }
    void setup_pre_exchange() override { make_room(); }
    void pre_exchange() override { make_room(); }
    void setup(int vflag) override
    {
        follow_ids();
        FixContacts::setup(vflag);
    }

    void grow_arrays(int count) override { memory_.grow(count); }
    void copy_arrays(int from, int to, int) override { memory_.copy(from, to); }
    void set_arrays(int i) override { memory_.forget(i); }
    int pack_exchange(int i, double* buffer) override { return memory_.pack(i, buffer); }
    int unpack_exchange(int i, double* buffer) override { return memory_.unpack(i, buffer); }

    int size_restart(int i) override { return 1 + memory_.size(i); }
    int maxsize_restart() override { return 1 + std::max(longest(), 2); }
    int pack_restart(int i, double* buffer) override
    {
        buffer[0] = size_restart(i);
        memory_.pack(i, buffer + 1);
        return size_restart(i);
    }
    void unpack_restart(int i, int place) override
    {
        const double* buffer = atom->extra[i];  // one fix's numbers behind the other's, each led by its size
        for (int n = 0; n < place; ++n)
            buffer += static_cast<int>(buffer[0]);
        memory_.unpack(i, buffer + 1);
    }

    int pack_comm(int n, int* list, double* buffer, int flag, int* pbc) override
    {
        if (!tells_ids_) return FixContacts::pack_comm(n, list, buffer, flag, pbc);
        for (int k = 0; k < n; ++k)
            buffer[k] = old_ids_[static_cast<std::size_t>(list[k])];
        return 1;
    }
    void unpack_comm(int n, int first, double* buffer) override
    {
        if (!tells_ids_) return FixContacts::unpack_comm(n, first, buffer);
        for (int k = 0; k < n; ++k)
            old_ids_[static_cast<std::size_t>(first + k)] = static_cast<int>(buffer[k]);
    }

protected:
    /// law(contact, state) -> Push; otherwise as FixContacts::each_contact(). Where contact.step is 0 a state must not
    /// change.
    template <class Law>
    void each_contact(const Law& law)
    {
        begin_step();
        visit([&](int i, Partner partner, const Contact& contact) {
            return law(contact, memory_.recall(i, partner, contact.normal));
        });
        end_step(memory_.end_step(atom->tag, atom->nlocal));
    }

private:
    static constexpr int exchanged = 0, restarted = 1;  // LIGGGHTS's numbers

    void make_room()
    {
        ask_for_room(*comm, world, atom->nlocal, [&](int i) { return memory_.size(i); });
    }

    /// Between two runs `delete_atoms` gives ids anew.
    void follow_ids()
    {
        int renamed = 0;
        for (int i = 0; i < atom->nlocal; ++i)
            if (memory_.id(i) != 0 && memory_.id(i) != atom->tag[i]) renamed = 1;
        MPI_Allreduce(MPI_IN_PLACE, &renamed, 1, MPI_INT, MPI_MAX, world);
        if (!renamed) return;
        const int count = atom->nlocal + atom->nghost;
        old_ids_.assign(static_cast<std::size_t>(count), 0);
        for (int i = 0; i < atom->nlocal; ++i)
            old_ids_[static_cast<std::size_t>(i)] = memory_.id(i);
        tells_ids_ = true;
        comm->forward_comm_fix(this);
        tells_ids_ = false;
        std::unordered_map<int, int> now;
        for (int i = 0; i < count; ++i)
            if (const int old = old_ids_[static_cast<std::size_t>(i)]) now[old] = atom->tag[i];
        memory_.rename(now, atom->nlocal);
    }

    ContactMemory<State> memory_;
    std::vector<int> old_ids_;  ///< [atoms, ghosts included]
    bool tells_ids_ = false;
};

}  // namespace interphase::contacts
