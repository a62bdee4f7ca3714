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
        const double width = rules_.width > 0 ? rules_.width : rules_.width_in_diameters * diameter;
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
            if (rules_.type == MappingType::cell_centre) return 0.0;
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
        words += text(sizes.width) + " m wide, or as a cell where that is wider";
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
    if (rules_.type == MappingType::cell_centre) return false;
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

double Mapping::half_variance(double width, double of_points, double distance)
{
    return 0.5 * std::max(0.0, variance_of(width) - variance_of(distance) - of_points);
}

KernelVolume Mapping::kernel_volume(const Vector& position, int cell, double volume, const Vector& velocity) const
{
    const auto own = static_cast<std::size_t>(cell);
    const double cell_volume = cells_.volume(own);
    if (rules_.type == MappingType::cell_centre) return {cell_volume, cell_volume};

    const SizeClass& sizes = classes_[class_of(volume)];
    const double side = std::cbrt(cell_volume), square = side * side;
    const double by_points = sizes.variance_of_points;
    const double by_diffusion = 2 * half_variance(sizes.width, by_points, side);
    // Points about the particle even out where in its cell it is; diffusion on a mesh spreads less at first than its
    // variance says. Both numbers are fits to uniform boxes of 0.5 to 2 diameters.
    constexpr double mean_crowding = 0.41, evening = 3.2, delay = 0.04;
    const double spread =
        by_points + (by_diffusion > 0 ? by_diffusion * by_diffusion / (by_diffusion + delay * square) : 0.0);
    const auto with_crowding = [&](double crowding) {
        const double deviation = kernel_deviation(cell_volume / crowding);
        return interphase::kernel_volume(deviation * deviation + spread);
    };
    const double left = std::exp(-evening * by_points / square);
    const auto evened = [&](double crowding) { return mean_crowding + left * (crowding - mean_crowding); };
    const double here = evened(crowding(position, own));
    const double speed = velocity.norm();
    if (!(speed > 0)) return {with_crowding(here), with_crowding(here)};

    // Two places half a cell apart have the mean of all on the line between cells' centres; and a sphere against its
    // trace, half a cell before and behind it, has 0.88 of that.
    constexpr double trace = 0.88;
    const Vector step = 0.5 * side / speed * velocity;
    const bool ahead = step.dot(subdivision_.centre(own) - position) > 0;
    const Vector there = position + (ahead ? 1 : -1) * step;
    return {with_crowding(here), with_crowding(trace * 0.5 * (here + evened(crowding(there, own))))};
}

double Mapping::crowding(const Vector& position, std::size_t cell) const
{
    const CellSubdivision::Place at = subdivision_.place(position, cell);
    const CornerCells::Cells& even = corner_cells_.at(at.corner);
    if (even.is_even()) {  // along each axis the parts 1 - a/2 and a/2
        double product = 1;
        for (std::size_t axis = 0; axis < 3; ++axis)
            product *= 1 - even.open[axis] * at.smoothed[axis] * (1 - 0.5 * at.smoothed[axis]);
        return product;
    }
    const CellSubdivision::Corner& corner = subdivision_.corner(at.corner);
    const std::array<double, 8> function = at.functions();
    std::array<double, 8> share{};  // of the cell, in each joint of the corner
    for (std::size_t n = 0; n < 8; ++n) {
        if (corner[n] < 0) continue;
        for (const Joints::Share& part : joints_.shares(corner[n]))
            if (part.cell == static_cast<int>(cell)) share[n] = part.part;
    }
    // Where cells are alike and meet as boxes do, two joints have in common what the joint of both their faces has: its
    // cells, which are as many as the cell's share of it says.
    double sum = 0;
    for (std::size_t n = 0; n < 8; ++n)
        for (std::size_t m = 0; m < 8; ++m)
            sum += function[n] * function[m] * (corner[n | m] >= 0 ? share[n | m] : std::min(share[n], share[m]));
    return sum > 0 ? sum : 1.0;
}

void Mapping::place(const Vectors& positions, const std::vector<int>& cells, const Scalars& volumes)
{
    particles_ = positions.size();
    cover(volumes);
    for (SizeClass& sizes : classes_)
        sizes.weights.clear();
    bool some_as_points = false;
    for (const SizeClass& sizes : classes_)
        some_as_points |= sizes.as_points();
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
    if (!some_as_points) return;
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
