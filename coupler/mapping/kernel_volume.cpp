// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/kernel_volume.hpp"

#include <algorithm>

#include "mapping/mapping.hpp"

namespace interphase {

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

}  // namespace interphase
