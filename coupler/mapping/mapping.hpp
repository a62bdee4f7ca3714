// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mapping/cell_weights.hpp"
#include "mapping/diffusion.hpp"
#include "mapping/kernel_volume.hpp"
#include "mapping/mapping_type.hpp"
#include "mapping/packing_limit.hpp"

namespace interphase {

/// Particles to gas cells and back in one pair of transposed operators: weights in a particle's own cell and those that
/// meet it, diffusion to the width that its size asks for, and the packing limit. README.md derives them.
class Mapping {
public:
    /// Collective; the mesh must not change afterwards.
    Mapping(const Communicator& comm, const MeshView& mesh, const MappingRules& rules);
    Mapping(const Mapping&) = delete;  // its parts know each other by address
    Mapping& operator=(const Mapping&) = delete;

    /// Computes the weights of the particles that visit this rank: `positions` [n, m], `cells` [n], `volumes` of the
    /// tracked spheres [n, m3]. Collective.
    void place(const Vectors& positions, const std::vector<int>& cells, const Scalars& volumes);

    /// Solid volume per cell [m3] from that of each particle, within the packing limit. Fixes the packing hand-over for
    /// this step. Collective.
    Scalars solid_volume(const Scalars& of_particles);

    /// Contents of the own cells, sum_i w_ic q_i [own cells], of a record of doubles: deposition. After solid_volume().
    /// Collective.
    template <class Record>
    std::vector<Record> deposit(const std::vector<Record>& of_particles) const
    {
        std::vector<Record> content = spread(of_particles);
        limit_.hand_over(content);
        return content;
    }

    /// Values at the particles, sum_c w_ic q_c [n], of own-cell values: interpolation, its transpose. After
    /// solid_volume(). Collective.
    template <class Record>
    void interpolate(std::vector<Record> of_cells, std::vector<Record>& of_particles) const
    {
        limit_.take_from_receivers(of_cells);
        of_particles.resize(particles_);
        for (const SizeClass& sizes : classes_) {
            sizes.diffusion.smooth(of_cells);
            sizes.weights.interpolate(of_cells, of_particles);
        }
    }

    /// Of particle i, in cell `cell`. Exact for weights on cells that are alike; diffusion adds its variance, as if
    /// both were Gaussian, less what the mesh does not let through.
    KernelVolume kernel_volume(std::size_t i, int cell) const;

    long cells_relieved() const { return limit_.cells_relieved(); }
    std::size_t bytes_sent() const { return joints_.bytes_sent() + cells_.bytes_sent(); }

private:
    /// Particles whose diameters differ by less than an octave share a width. From the smallest to the largest: what a
    /// class diffuses beside those before it, and its particles.
    struct SizeClass {
        Diffusion diffusion;
        CellWeights weights;
    };

    template <class Record>
    std::vector<Record> spread(const std::vector<Record>& of_particles) const
    {
        std::vector<Record> content(cells_.own_count(), Record{});
        for (auto sizes = classes_.rbegin(); sizes != classes_.rend(); ++sizes) {
            sizes->weights.deposit(of_particles, content);
            sizes->diffusion.spread(content);
        }
        return content;
    }

    int octave_of(double volume) const;
    double width_of(int octave) const;
    void cover(const Scalars& volumes);

    Communicator comm_;
    MappingRules rules_;
    CellGraph cells_;
    CellSubdivision subdivision_;
    Joints joints_;
    PackingLimit limit_;
    std::size_t particles_ = 0;
    struct Slot {
        std::size_t size_class, index;
    };
    std::vector<Slot> slots_;  ///< of the particles: where in classes_

    int first_octave_ = 0;  ///< of classes_; an octave of diameters is numbered by its middle, 0 at reference_
    std::vector<SizeClass> classes_;
    double reference_ = 0;  ///< diameter of the largest particle that was there first [m]
};

}  // namespace interphase
