// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/mapping.hpp"

#include <algorithm>
#include <cmath>

namespace interphase {

namespace {

double diameter_of(double volume) { return std::cbrt(6 / M_PI * volume); }

/// Of a Gaussian of that width at half height. Widths of kernels one after the other add as their squares; that of the
/// weights is the distance between the cells.
double variance_of(double width) { return width * width / (8 * std::log(2.0)); }

}  // namespace

Mapping::Mapping(const Communicator& comm, const MeshView& mesh, const MappingRules& rules)
    : comm_(comm),
      rules_(rules),
      cells_(comm, mesh),
      numbering_(comm, mesh),
      subdivision_(mesh, numbering_),
      joints_(comm, numbering_, subdivision_, mesh.size()),
      corner_cells_(subdivision_, joints_),
      limit_(cells_, comm, rules.maximum_packing)
{}

int Mapping::octave_of(double volume) const
{
    if (rules_.width > 0 || rules_.type == MappingType::cell_centre) return 0;
    return static_cast<int>(std::ceil(std::log2(diameter_of(volume) / reference_) - 1e-6));
}

void Mapping::cover(const Scalars& volumes)
{
    double smallest = 1e300, largest = 0;
    for (const double volume : volumes) {
        smallest = std::min(smallest, volume);
        largest = std::max(largest, volume);
    }
    const Vector of_all = comm_.max(Vector(-smallest, largest, 0));
    smallest = -of_all[0];
    largest = of_all[1];
    if (!(largest > 0)) return;  // nobody is there
    if (reference_ == 0) reference_ = diameter_of(largest);

    const int count = static_cast<int>(classes_.size());
    int first = octave_of(smallest), last = octave_of(largest);
    if (count > 0 && first >= first_octave_ && last < first_octave_ + count) return;
    if (count > 0) {
        first = std::min(first, first_octave_);
        last = std::max(last, first_octave_ + count - 1);
    }
    first_octave_ = first;
    classes_.clear();
    const auto half_variance = [&](int octave, double distance) {
        const double width =
            rules_.width > 0 ? rules_.width : rules_.width_in_diameters * reference_ * std::exp2(octave);
        return 0.5 * std::max(0.0, variance_of(width) - variance_of(distance));
    };
    for (int octave = first; octave <= last; ++octave) {
        const auto beside_those_before = [&](double distance) {
            if (rules_.type == MappingType::cell_centre) return 0.0;
            return half_variance(octave, distance) - (octave > first ? half_variance(octave - 1, distance) : 0.0);
        };
        classes_.push_back({Diffusion(cells_, comm_, beside_those_before),
                            CellWeights(joints_, subdivision_, corner_cells_, cells_.own_count())});
    }
}

void Mapping::place(const Vectors& positions, const std::vector<int>& cells, const Scalars& volumes)
{
    particles_ = positions.size();
    cover(volumes);
    for (SizeClass& sizes : classes_)
        sizes.weights.clear();
    for (std::size_t i = 0; i < particles_; ++i) {
        const int octave = classes_.size() > 1 ? octave_of(volumes[i]) - first_octave_ : 0;
        CellWeights& weights = classes_[static_cast<std::size_t>(octave)].weights;
        if (rules_.type == MappingType::kernel)
            weights.add_spread(i, positions[i], cells[i]);
        else
            weights.add_to_cell(i, cells[i]);
    }
}

Scalars Mapping::solid_volume(const Scalars& of_particles)
{
    Scalars volume = spread(of_particles);
    limit_.relieve(volume);
    return volume;
}

}  // namespace interphase
