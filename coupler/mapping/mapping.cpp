// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/mapping.hpp"

#include <algorithm>
#include <cmath>

namespace interphase {

namespace {

double diameter_of(double volume) { return std::cbrt(6 / M_PI * volume); }

/// Of a Gaussian of that width at half height.
double variance_of(double width) { return width * width / (8 * std::log(2.0)); }

/// Of what the weights do in a uniform grid of boxes: those of a hat.
double variance_of_weights(double distance) { return distance * distance / 6; }

}  // namespace

Mapping::Mapping(const Communicator& comm, const MeshView& mesh, const MappingRules& rules)
    : comm_(comm),
      rules_(rules),
      cells_(comm, mesh),
      subdivision_(mesh),
      joints_(comm, mesh, subdivision_),
      limit_(cells_, comm, rules.maximum_packing)
{}

int Mapping::octave_of(double volume) const
{
    if (rules_.width > 0 || rules_.type == MappingType::cell_centre) return 0;
    return static_cast<int>(std::lround(std::log2(diameter_of(volume) / reference_)));
}

double Mapping::width_of(int octave) const
{
    return rules_.width > 0 ? rules_.width : rules_.width_in_diameters * reference_ * std::exp2(octave);
}

KernelVolume Mapping::kernel_volume(std::size_t i, int cell) const
{
    const Slot slot = slots_[i];
    const double cell_volume = cells_.volume(static_cast<std::size_t>(cell));
    const double here = cell_volume / classes_[slot.size_class].weights.crowding(slot.index, cell);
    if (rules_.type == MappingType::cell_centre) return {here, here};
    constexpr double mean_crowding = 0.27;  // of the weights in a box: 1 at its centre, 1/8 at a corner
    const double on_its_way = cell_volume / mean_crowding;

    const double side = std::cbrt(cell_volume);
    const double added =
        variance_of(width_of(first_octave_ + static_cast<int>(slot.size_class))) - variance_of_weights(side);
    if (!(added > 0)) return {here, on_its_way};
    // A mesh lets less through at first: 0.08 is of the overlap of its exact solution, within 3 % of the deviation.
    const double variance = added * added / (added + 0.08 * side * side);
    const auto diffused = [&](double by_weights) {
        const double deviation = kernel_deviation(by_weights);
        return interphase::kernel_volume(deviation * deviation + variance);
    };
    return {diffused(here), diffused(on_its_way)};
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
        return 0.5 * std::max(0.0, variance_of(width_of(octave)) - variance_of_weights(distance));
    };
    for (int octave = first; octave <= last; ++octave) {
        const auto beside_those_before = [&](double distance) {
            if (rules_.type == MappingType::cell_centre) return 0.0;
            return half_variance(octave, distance) - (octave > first ? half_variance(octave - 1, distance) : 0.0);
        };
        classes_.push_back(
            {Diffusion(cells_, comm_, beside_those_before), CellWeights(joints_, subdivision_, cells_.own_count())});
    }
}

void Mapping::place(const Vectors& positions, const std::vector<int>& cells, const Scalars& volumes)
{
    particles_ = positions.size();
    slots_.resize(particles_);
    cover(volumes);
    for (SizeClass& sizes : classes_)
        sizes.weights.clear();
    for (std::size_t i = 0; i < particles_; ++i) {
        const int octave = classes_.size() > 1 ? octave_of(volumes[i]) - first_octave_ : 0;
        CellWeights& weights = classes_[static_cast<std::size_t>(octave)].weights;
        slots_[i] = {static_cast<std::size_t>(octave), weights.particles()};
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
