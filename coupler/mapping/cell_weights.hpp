// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mapping/cell_subdivision.hpp"
#include "mapping/corner_cells.hpp"
#include "mapping/joints.hpp"

namespace interphase {

/// The weights w_ic with which particle i belongs to cell c; sum_c w_ic = 1 for each i. The same weights carry particle
/// data to the cells and gas data back, which is what conserves momentum between the two.
///
/// w_ic = sum_j N_j(x_i) S_jc: the functions N_j of the joints of the subdivided mesh, and the cells' shares S_jc of
/// them. On a uniform grid of boxes w is 1 at a cell's centre, 1/2 at the middle of its face, 1/8 at its corner and 0
/// at its neighbours' centres, as cloud-in-cell's is (Hockney and Eastwood, Computer Simulation Using Particles, 1988,
/// ch. 5). It changes continuously as a particle moves, on any mesh, and a uniform density of particles fills every
/// cell alike.
///
/// Joints that ranks share keep an entry of their own beside the cells, and are summed over the ranks.
class CellWeights {
public:
    CellWeights(const Joints& joints, const CellSubdivision& subdivision, const CornerCells& corner_cells,
                std::size_t cells);

    /// Forgets all particles.
    void clear();

    /// Particle number `particle` of the records to come, wholly in its own cell.
    void add_to_cell(std::size_t particle, int cell);
    /// The same, spread as above.
    void add_spread(std::size_t particle, const Vector& position, int cell);

    /// One of the points that stand for a particle, with its share of it; the particle follows with the last of them.
    void add_point(const Vector& position, int cell, double share);
    void end_particle(std::size_t particle);

    std::size_t particles() const { return particle_.size(); }

    /// Adds sum_i w_ic q_i to `of_cells` [cells]. Collective.
    template <class Record>
    void deposit(const std::vector<Record>& of_particles, std::vector<Record>& of_cells) const
    {
        of_cells.resize(cells_ + joints_.shared().size(), Record{});
        for (std::size_t i = 0; i < particles(); ++i) {
            const Numbers<Record> q = numbers(of_particles[particle_[i]]);
            for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
                numbers(of_cells[entries_[k].place]) += entries_[k].weight * q;
        }
        std::vector<Record> of_shared = joints_at_the_end(of_cells);
        joints_.sum_shared(of_shared);
        for (std::size_t n = 0; n < of_shared.size(); ++n)
            for (const Joints::Share& share : joints_.shares(joints_.shared()[n]))
                numbers(of_cells[static_cast<std::size_t>(share.cell)]) += share.part * numbers(of_shared[n]);
        of_cells.resize(cells_);
    }

    /// sum_c w_ic q_c for each particle, written to `of_particles` at its number. Collective.
    template <class Record>
    void interpolate(std::vector<Record>& of_cells, std::vector<Record>& of_particles) const
    {
        std::vector<Record> of_shared(joints_.shared().size(), Record{});
        for (std::size_t n = 0; n < of_shared.size(); ++n)
            for (const Joints::Share& share : joints_.shares(joints_.shared()[n]))
                numbers(of_shared[n]) += share.part * numbers(of_cells[static_cast<std::size_t>(share.cell)]);
        joints_.sum_shared(of_shared);
        of_cells.insert(of_cells.end(), of_shared.begin(), of_shared.end());
        for (std::size_t i = 0; i < particles(); ++i) {
            Numbers<Record> q = Numbers<Record>::Zero();
            for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
                q += entries_[k].weight * numbers(of_cells[entries_[k].place]);
            numbers(of_particles[particle_[i]]) = q;
        }
        of_cells.resize(cells_);
    }

private:
    static constexpr int nowhere = -1;

    struct Entry {
        std::size_t place;  ///< a cell, or behind the cells a shared joint
        double weight;
    };

    template <class Record>
    std::vector<Record> joints_at_the_end(const std::vector<Record>& of_cells) const
    {
        return std::vector<Record>(of_cells.begin() + static_cast<std::ptrdiff_t>(cells_), of_cells.end());
    }

    void make_room(std::size_t entries);
    void add_joints(const CellSubdivision::Place& at, double share);
    void add(int joint, double weight);
    void add_at(int place, double weight);

    const Joints& joints_;
    const CellSubdivision& subdivision_;
    const CornerCells& corner_cells_;
    std::size_t cells_;
    std::vector<int> entry_at_;  ///< of the particle that is being added, at each place; or nowhere
    std::vector<std::size_t> particle_;
    std::vector<std::size_t> first_{0};  ///< entry of each particle, and one past the last
    std::vector<Entry> entries_;         ///< what follows the last is spare
    std::size_t used_ = 0;
};

}  // namespace interphase
