// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/mapping.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "mapping/sphere_points.hpp"

namespace interphase {

namespace {

double diameter_of(double volume) { return std::cbrt(6 / M_PI * volume); }

/// Of a Gaussian of that width at half height. Widths of kernels one after the other add as their squares; that of the
/// weights is the distance between the cells.
double variance_of(double width) { return width * width / (8 * std::log(2.0)); }

}  // namespace

Mapping::Mapping(const Communicator& comm, const MeshView& mesh, const MappingRules& rules)
    : Mapping(comm, mesh, rules, JointNumbering(comm, mesh))
{}

Mapping::Mapping(const Communicator& comm, const MeshView& mesh, const MappingRules& rules,
                 const JointNumbering& numbering)
    : comm_(comm),
      rules_(rules),
      cells_(comm, mesh),
      subdivision_(mesh, numbering),
      joints_(comm, numbering, subdivision_, mesh.size()),
      corner_cells_(subdivision_, joints_),
      paths_(mesh, subdivision_),
      guests_(comm, mesh, paths_),
      limit_(cells_, comm, rules.maximum_packing)
{}

int Mapping::octave_of(double volume) const
{
    if (rules_.type == MappingType::cell_centre) return 0;
    return static_cast<int>(std::ceil(std::log2(diameter_of(volume) / octaves_.reference) - 1e-6));
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
    if (octaves_.reference == 0) octaves_.reference = diameter_of(largest);
    octaves_.first = std::min(octaves_.first, octave_of(smallest));
    octaves_.last = std::max(octaves_.last, octave_of(largest));
    if (static_cast<int>(classes_.size()) != octaves_.last - octaves_.first + 1) make_classes();
}

void Mapping::make_classes()
{
    struct Asked {
        int octave;
        double diameter, width, of_points;
        double to_diffuse() const { return variance_of(width) - of_points; }
    };
    std::vector<Asked> all;
    for (int octave = octaves_.first; octave <= octaves_.last; ++octave) {
        const double diameter = octaves_.reference * std::exp2(octave);
        const double width = width_for(diameter);
        const double of_points = needs_points(diameter, width) ? SpherePoints::variance * diameter * diameter : 0.0;
        all.push_back({octave, diameter, width, of_points});
    }
    // in the order of sizes, unless all have the same width, where points take their part of it
    std::stable_sort(all.begin(), all.end(),
                     [](const Asked& a, const Asked& b) { return a.to_diffuse() < b.to_diffuse(); });

    classes_.clear();
    class_of_octave_.assign(all.size(), 0);
    for (const Asked& asked : all) {
        const auto beside_those_before = [&](double distance) {
            double more = half_variance(asked.width, asked.of_points, distance);
            if (!classes_.empty())
                more -= half_variance(classes_.back().width, classes_.back().variance_of_points, distance);
            return std::max(0.0, more);
        };
        Diffusion diffusion(cells_, comm_, beside_those_before);
        class_of_octave_[static_cast<std::size_t>(asked.octave - octaves_.first)] = classes_.size();
        classes_.push_back({asked.diameter, asked.width, asked.of_points, std::move(diffusion),
                            CellWeights(joints_, subdivision_, corner_cells_, cells_.own_count())});
    }
}

double Mapping::width_for(double diameter) const
{
    if (rules_.type == MappingType::cell_centre) return 0;
    return rules_.width > 0 ? rules_.width : rules_.width_in_diameters * diameter;
}

std::size_t Mapping::class_of(double volume) const
{
    if (classes_.size() == 1) return 0;
    return class_of_octave_[static_cast<std::size_t>(octave_of(volume) - octaves_.first)];
}

std::string Mapping::description(const Scalars& volumes)
{
    if (rules_.type == MappingType::cell_centre) return "to the cell that holds the centre";
    cover(volumes);
    std::string words;
    for (std::size_t n = 0; n < classes_.size(); ++n) {
        const SizeClass& sizes = classes_[n];
        if (n > 0) words += "; ";
        if (rules_.width == 0) words += "spheres up to " + text(sizes.diameter) + " m: ";
        words += text(sizes.width) + " m wide in cells below " + text(wide_enough(sizes.width)) + " m";
        if (sizes.as_points()) words += ", as " + std::to_string(SpherePoints::all().size()) + " points";
        if (sizes.diffusion.sweeps() > 0)
            words += ", diffused in " + std::to_string(sizes.diffusion.sweeps()) + " sweeps";
    }
    return words;
}

bool Mapping::needs_points(double diameter, double width) const
{
    // Wider cells blur a packing's pattern with their own weights, in narrower ones diffusion does.
    constexpr double widest = 1.9, narrowest = 0.44;
    if (variance_of(width) < SpherePoints::variance * diameter * diameter)
        return false;  // narrower than the points are
    return has_cells_between(narrowest * diameter, widest * diameter);
}

bool Mapping::has_cells_between(double least, double most) const
{
    bool some = false;
    for (std::size_t c = 0; c < cells_.own_count() && !some; ++c)
        for (auto link = cells_.links_begin(c); link != cells_.links_end(c); ++link)
            some |= link->distance > least && link->distance < most;
    return comm_.any(some);
}

bool Mapping::has_cells_of(double least, double most) const
{
    return std::any_of(classes_.begin(), classes_.end(), [&](const SizeClass& sizes) {
        return has_cells_between(least * sizes.diameter, most * sizes.diameter);
    });
}

double Mapping::wide_enough(double width) const { return (rules_.width > 0 ? 1 : MappingRules::wide_enough) * width; }

double Mapping::half_variance(double width, double of_points, double distance) const
{
    // cells are often made as wide as that, and then round-off shall not part them
    constexpr double tie = 1e-6;
    if (distance >= (1 - tie) * wide_enough(width)) return 0;
    return 0.5 * std::max(0.0, variance_of(width) - variance_of(distance) - of_points);
}

void Mapping::place(const Vectors& positions, const std::vector<int>& cells, const Scalars& volumes)
{
    particles_ = positions.size();
    cover(volumes);
    for (SizeClass& sizes : classes_)
        sizes.weights.clear();
    for (std::size_t i = 0; i < particles_; ++i) {
        const std::size_t size_class = class_of(volumes[i]);
        SizeClass& sizes = classes_[size_class];
        if (rules_.type == MappingType::cell_centre)
            sizes.weights.add_to_cell(i, cells[i]);
        else if (sizes.as_points())
            add_as_points(size_class, i, positions[i], cells[i]);
        else
            sizes.weights.add_spread(i, positions[i], cells[i]);
    }
    const auto as_points = [](const SizeClass& sizes) { return sizes.as_points(); };
    if (std::none_of(classes_.begin(), classes_.end(), as_points)) return;
    for (const Guests::Point& guest : guests_.arrive(particles_)) {
        CellWeights& weights = classes_[static_cast<std::size_t>(guest.size_class)].weights;
        weights.add_point(subdivision_.centre(static_cast<std::size_t>(guest.path.cell)) + guest.path.to,
                          guest.path.cell, guest.share);
        weights.end_particle(static_cast<std::size_t>(guest.particle));
    }
    some_have_guests_ = comm_.any(guests_.count() > 0);
}

void Mapping::add_as_points(std::size_t size_class, std::size_t particle, const Vector& position, int cell)
{
    SizeClass& sizes = classes_[size_class];
    const Vector from = position - subdivision_.centre(static_cast<std::size_t>(cell));
    for (const SpherePoints::Point& point : SpherePoints::all()) {
        StraightPaths::Path path{cell, from, from + sizes.diameter * point.offset};
        const int face = paths_.follow(path);
        if (face >= 0)
            guests_.leave(face,
                          {path, point.share, comm_.rank(), static_cast<int>(particle), static_cast<int>(size_class)});
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
