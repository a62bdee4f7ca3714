// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/mapping.hpp"

#include <algorithm>
#include <cmath>

#include "mapping/sphere_points.hpp"

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
      paths_(mesh, subdivision_),
      guests_(comm, mesh, paths_),
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
    for (int octave = first; octave <= last; ++octave) {
        const double width = width_of(octave);
        const bool as_points = needs_points(width);
        const auto beside_those_before = [&](double distance) {
            if (rules_.type == MappingType::cell_centre) return 0.0;
            double more = half_variance(width, as_points, distance);
            if (octave > first) more -= half_variance(classes_.back().width, classes_.back().as_points, distance);
            return std::max(0.0, more);
        };
        Diffusion diffusion(cells_, comm_, beside_those_before);
        classes_.push_back({width, as_points, std::move(diffusion),
                            CellWeights(joints_, subdivision_, corner_cells_, cells_.own_count())});
    }
}

double Mapping::width_of(int octave) const
{
    return rules_.width > 0 ? rules_.width : rules_.width_in_diameters * reference_ * std::exp2(octave);
}

bool Mapping::needs_points(double width) const
{
    // Wider cells blur a packing's pattern with their own weights, in narrower ones diffusion does.
    constexpr double widest = 1.05, narrowest = 0.22;
    if (rules_.type == MappingType::cell_centre) return false;
    bool some = false;
    for (std::size_t c = 0; c < cells_.own_count() && !some; ++c)
        for (auto link = cells_.links_begin(c); link != cells_.links_end(c); ++link)
            some |= link->distance > narrowest * width && link->distance < widest * width;
    return comm_.any(some);
}

double Mapping::half_variance(double width, bool as_points, double distance) const
{
    const double of_points = as_points ? SpherePoints::variance * width * width / 4 : 0.0;
    return 0.5 * std::max(0.0, variance_of(width) - variance_of(distance) - of_points);
}

void Mapping::place(const Vectors& positions, const std::vector<int>& cells, const Scalars& volumes)
{
    particles_ = positions.size();
    cover(volumes);
    for (SizeClass& sizes : classes_)
        sizes.weights.clear();
    bool some_as_points = false;
    for (const SizeClass& sizes : classes_)
        some_as_points |= sizes.as_points;
    for (std::size_t i = 0; i < particles_; ++i) {
        const int octave = classes_.size() > 1 ? octave_of(volumes[i]) - first_octave_ : 0;
        SizeClass& sizes = classes_[static_cast<std::size_t>(octave)];
        if (rules_.type == MappingType::cell_centre)
            sizes.weights.add_to_cell(i, cells[i]);
        else if (sizes.as_points)
            add_as_points(sizes, i, positions[i], cells[i], octave);
        else
            sizes.weights.add_spread(i, positions[i], cells[i]);
    }
    if (!some_as_points) return;
    for (const Guests::Point& guest : guests_.arrive(particles_)) {
        CellWeights& weights = classes_[static_cast<std::size_t>(guest.octave)].weights;
        weights.add_point(subdivision_.centre(static_cast<std::size_t>(guest.path.cell)) + guest.path.to,
                          guest.path.cell, guest.share);
        weights.end_particle(static_cast<std::size_t>(guest.particle));
    }
    some_have_guests_ = comm_.any(guests_.count() > 0);
}

void Mapping::add_as_points(SizeClass& sizes, std::size_t particle, const Vector& position, int cell, int octave)
{
    const Vector from = position - subdivision_.centre(static_cast<std::size_t>(cell));
    for (const SpherePoints::Point& point : SpherePoints::all()) {
        StraightPaths::Path path{cell, from, from + sizes.width / 2 * point.offset};
        const int face = paths_.follow(path);
        if (face >= 0)
            guests_.leave(face, {path, point.share, comm_.rank(), static_cast<int>(particle), octave});
        else
            sizes.weights.add_point(subdivision_.centre(static_cast<std::size_t>(path.cell)) + path.to, path.cell,
                                    point.share);
    }
    sizes.weights.end_particle(particle);
}

Scalars Mapping::solid_volume(const Scalars& of_particles)
{
    Scalars volume = spread(of_particles);
    limit_.relieve(volume);
    return volume;
}

}  // namespace interphase
