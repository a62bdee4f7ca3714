// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "mapping/mapping.hpp"
#include "support/whole_mesh.hpp"

namespace interphase::test {

/// Spheres and their cells, numbered in the whole mesh; the same on all ranks.
struct Spheres {
    Vectors positions;
    std::vector<int> cells;
    Scalars volumes;  ///< [m3]

    std::size_t size() const { return positions.size(); }
    void add(const Vector& position, int cell, double volume);
};

double sphere_volume(double diameter);

/// `count` places in cells drawn at random, in each in a tetrahedron between its centre, the centre of a face and a
/// side of that; the sphere's diameter is `diameter(number)`.
Spheres scattered(const WholeMesh& mesh, std::size_t count, const std::function<double(std::size_t)>& diameter,
                  unsigned seed = 1);

/// The whole mesh as one rank has it.
MeshView whole_view(const WholeMesh& mesh);

/// Finds cells of any convex shape by trying all: the one whose faces the point lies farthest behind.
class CellFinder {
public:
    explicit CellFinder(const MeshView& mesh);
    int cell_at(const Vector& point) const;

private:
    struct Plane {
        Vector normal;
        double offset;
    };
    std::vector<std::vector<Plane>> planes_;
};

/// Which rank has which cell.
struct Partition {
    std::vector<int> rank_of, number_on;

    /// Any cell to any of `ranks`.
    static Partition at_random(std::size_t cells, int ranks, unsigned seed = 1);
};

/// A pseudo-random number between -1 and 1.
inline double noise(std::size_t i) { return std::sin(12.9898 * static_cast<double>(i) + 1.0); }

/// A mesh cut to ranks at random, its mapping, and those of the spheres that have their cell on this rank.
class MappedSpheres {
public:
    MappedSpheres(const Communicator& comm, const WholeMesh& mesh, const Spheres& spheres, const MappingRules& rules,
                  unsigned partition_seed = 1);

    /// Particle quantities and cell fields are functions of the number in the whole.
    template <class Function>
    auto of_particles(const Function& f) const
    {
        std::vector<decltype(f(std::size_t{}))> values;
        for (const std::size_t i : here)
            values.push_back(f(i));
        return values;
    }
    template <class Function>
    auto of_cells(const Function& f) const
    {
        std::vector<decltype(f(std::size_t{}))> values;
        for (const std::size_t c : own_cells)
            values.push_back(f(c));
        return values;
    }
    template <class Record>
    std::vector<Record> at_particles(const std::vector<Record>& cells) const
    {
        std::vector<Record> values;
        mapping.interpolate(cells, values);
        return values;
    }
    /// Solid volume of own cells when every sphere stands for `weight` of its volume; from then on the mapping has its
    /// packing limit.
    Scalars fill(double weight = 1)
    {
        return mapping.solid_volume(of_particles([&](std::size_t i) { return weight * volume_of_all_[i]; }));
    }

    double dot(const Scalars& a, const Scalars& b) const;
    double total(const Scalars& a) const { return dot(a, Scalars(a.size(), 1.0)); }

    /// Values of all cells, or all spheres, on every rank.
    Scalars of_whole_mesh(const Scalars& own) const { return everywhere(own, own_cells, cells_); }
    Scalars of_all_spheres(const Scalars& own) const { return everywhere(own, here, spheres_); }

private:
    Scalars everywhere(const Scalars& own, const std::vector<std::size_t>& numbers, std::size_t count) const;

    Communicator comm_;
    std::size_t cells_, spheres_;
    Scalars volume_of_all_;
    Partition partition_;

public:
    MeshView view;
    Mapping mapping;
    std::vector<std::size_t> own_cells;  ///< their numbers in the whole
    std::vector<std::size_t> here;       ///< numbers of this rank's spheres
    Scalars volumes;                     ///< of those [m3]
};

/// One sphere's solid content of unit volume in each cell of the whole.
Scalars weights_of(const Communicator& comm, const WholeMesh& mesh, const Vector& position, int cell, double diameter,
                   const MappingRules& rules);

}  // namespace interphase::test
