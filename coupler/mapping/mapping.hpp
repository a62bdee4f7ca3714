// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <climits>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "mapping/cell_weights.hpp"
#include "mapping/diffusion.hpp"
#include "mapping/guests.hpp"
#include "mapping/kernel_volume.hpp"
#include "mapping/mapping_type.hpp"
#include "mapping/packing_limit.hpp"
#include "mapping/straight_paths.hpp"

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
        of_particles.resize(particles_ + guests_.count());
        for (const SizeClass& sizes : classes_) {
            sizes.diffusion.smooth(of_cells);
            sizes.weights.interpolate(of_cells, of_particles);
        }
        if (some_have_guests_) guests_.send_home(of_particles);
    }

    /// What is done for particles of these volumes [n, m3], in words. Collective.
    std::string description(const Scalars& volumes);

    /// Whether some cells are so many diameters of some spheres apart, once description() or place() has seen these.
    /// Collective.
    bool has_cells_of(double least, double most) const;

    void keep(Archive& archive) { archive.keep("octaves", octaves_); }

    /// Of a tracked sphere of that volume [m3] at `position` [m] in cell `cell`, that moves along `velocity` on the
    /// mesh; once place() has seen its like. Within 13 % on uniform boxes; meant for places where the cells are alike.
    KernelVolume kernel_volume(const Vector& position, int cell, double volume, const Vector& velocity) const;

    long cells_relieved() const { return limit_.cells_relieved(); }
    std::size_t bytes_sent() const { return joints_.bytes_sent() + cells_.bytes_sent() + guests_.bytes_sent(); }

private:
    /// The numbering of joints is needed for the parts to be built, and not afterwards.
    Mapping(const Communicator& comm, const MeshView& mesh, const MappingRules& rules, const JointNumbering& numbering);

    /// Particles whose diameters differ by less than an octave share a width. From the least diffused to the most: what
    /// a class diffuses beside those before it, and its particles.
    struct SizeClass {
        double diameter;            ///< of the largest [m]
        double width;               ///< at half height [m]
        double variance_of_points;  ///< of SpherePoints of that diameter [m2]; 0: spread from their centres
        Diffusion diffusion;
        CellWeights weights;

        bool as_points() const { return variance_of_points > 0; }
    };

    template <class Record>
    std::vector<Record> spread(const std::vector<Record>& of_particles) const
    {
        if (some_have_guests_) return spread_points(guests_.with_guests(of_particles));
        return spread_points(of_particles);
    }
    template <class Record>
    std::vector<Record> spread_points(const std::vector<Record>& of_particles) const
    {
        std::vector<Record> content(cells_.own_count(), Record{});
        for (auto sizes = classes_.rbegin(); sizes != classes_.rend(); ++sizes) {
            sizes->weights.deposit(of_particles, content);
            sizes->diffusion.spread(content);
        }
        return content;
    }

    int octave_of(double volume) const;
    std::size_t class_of(double volume) const;
    double width_for(double diameter) const;  ///< that it asks for [m]; 0: the cell that holds the centre
    bool needs_points(double diameter, double width) const;
    bool has_cells_between(double least, double most) const;  ///< [m]. Collective.
    double wide_enough(
        double width) const;  ///< cells as far apart as that need no kernel of that width beside their own
    double half_variance(double width, double of_points, double distance) const;
    double crowding(const Vector& position, std::size_t cell) const;
    void cover(const Scalars& volumes);
    void make_classes();
    void add_as_points(std::size_t size_class, std::size_t particle, const Vector& position, int cell);

    Communicator comm_;
    MappingRules rules_;
    CellGraph cells_;
    CellSubdivision subdivision_;
    Joints joints_;
    CornerCells corner_cells_;
    StraightPaths paths_;
    Guests guests_;
    PackingLimit limit_;
    std::size_t particles_ = 0;
    bool some_have_guests_ = false;  ///< on any rank

    /// Octaves of diameters that have been here, all of which keep a class: each ends at `reference` times a power of
    /// two, the diameter of the largest particle that was there first [m].
    struct Octaves {
        double reference = 0;
        int first = INT_MAX, last = INT_MIN;
    };
    Octaves octaves_;
    std::vector<SizeClass> classes_;  ///< by what they diffuse
    std::vector<std::size_t> class_of_octave_;
};

}  // namespace interphase
