// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mapping/cell_subdivision.hpp"
#include "mapping/joints.hpp"

namespace interphase {

/// The weights w_ic with which particle i belongs to cell c; sum_c w_ic = 1 for each i. The same weights carry particle
/// data to the cells and gas data back, which is what conserves momentum between the two.
///
/// w_ic = sum_j N_j(x_i) S_jc: the functions N_j that are linear in each tetrahedron of the subdivided mesh, and the
/// cells' shares S_jc of the joints they belong to. On a uniform grid of boxes w is 1 at a cell's centre, 1/2 at the
/// middle of its face, 1/8 at its corner and 0 at its neighbours' centres, as cloud-in-cell's is (Hockney and Eastwood,
/// Computer Simulation Using Particles, 1988, ch. 5). It changes continuously as a particle moves, on any mesh, and a
/// uniform density of particles fills every cell alike.
class CellWeights {
public:
    CellWeights(const Joints& joints, const CellSubdivision& subdivision, std::size_t cells)
        : joints_(joints), subdivision_(subdivision), cells_(cells), number_(joints.count(), unused)
    {}

    /// Forgets all particles.
    void clear();

    /// Particle number `particle` of the records to come, wholly in its own cell.
    void add_to_cell(std::size_t particle, int cell);
    /// The same, spread as above.
    void add_spread(std::size_t particle, const Vector& position, int cell);

    std::size_t particles() const { return particle_.size(); }

    /// sum_c w_ic^2 V_own/V_c of the `index`-th particle added, whose own cell is `cell`: over how few cells it is
    /// spread, 1 at most. Exact where the cells at a joint are alike.
    double crowding(std::size_t index, int cell) const;

    /// Adds sum_i w_ic q_i to `of_cells` [cells]. Collective.
    template <class Record>
    void deposit(const std::vector<Record>& of_particles, std::vector<Record>& of_cells) const
    {
        std::vector<Record> of_joints(used_.size(), Record{});
        for (std::size_t i = 0; i < particles(); ++i) {
            const Numbers<Record> q = numbers(of_particles[particle_[i]]);
            for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
                numbers(of_joints[entries_[k].joint]) += entries_[k].weight * q;
        }
        joints_.sum_shared(of_joints);
        for (std::size_t n = 0; n < used_.size(); ++n) {
            const Numbers<Record> q = numbers(of_joints[n]);
            for (const auto* share = joints_.shares_begin(used_[n]); share != joints_.shares_end(used_[n]); ++share)
                numbers(of_cells[static_cast<std::size_t>(share->cell)]) += share->part * q;
        }
    }

    /// sum_c w_ic q_c for each particle, written to `of_particles` at its number. Collective.
    template <class Record>
    void interpolate(const std::vector<Record>& of_cells, std::vector<Record>& of_particles) const
    {
        std::vector<Record> of_joints(used_.size());
        for (std::size_t n = 0; n < used_.size(); ++n) {
            Numbers<Record> q = Numbers<Record>::Zero();
            for (const auto* share = joints_.shares_begin(used_[n]); share != joints_.shares_end(used_[n]); ++share)
                q += share->part * numbers(of_cells[static_cast<std::size_t>(share->cell)]);
            numbers(of_joints[n]) = q;
        }
        joints_.sum_shared(of_joints);
        for (std::size_t i = 0; i < particles(); ++i) {
            Numbers<Record> q = Numbers<Record>::Zero();
            for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
                q += entries_[k].weight * numbers(of_joints[entries_[k].joint]);
            numbers(of_particles[particle_[i]]) = q;
        }
    }

private:
    static constexpr int unused = -1;

    struct Entry {
        std::size_t joint;  ///< place in used_
        double weight;
    };

    void add(int joint, double weight);

    const Joints& joints_;
    const CellSubdivision& subdivision_;
    std::size_t cells_;
    std::vector<int> number_;  ///< of each joint: its place in used_, or unused
    std::vector<int> used_;    ///< joints that some particle touches; first those that ranks share
    std::vector<std::size_t> particle_;
    std::vector<std::size_t> first_{0};  ///< entry of each particle, and one past the last
    std::vector<Entry> entries_;
};

}  // namespace interphase
