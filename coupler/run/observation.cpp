// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/observation.hpp"

#include <algorithm>

namespace interphase {

std::vector<Results::Entry> Observation::row(double time) const
{
    std::vector<Results::Entry> row{{"time", "s", time},
                                    {"particles", "1", static_cast<double>(particles)},
                                    {"particles_in", "1", came},
                                    {"particles_out", "1", went},
                                    {"kinetic_energy", "J", kinetic_energy},
                                    {"bed_height", "m", bed_height},
                                    {"vertical_velocity", "m/s", vertical_velocity}};
    if (!gas) return row;
    if (gas->pressure_drop) row.push_back({"pressure_drop", "Pa", *gas->pressure_drop});
    row.push_back({"bed_weight_per_area", "Pa", gas->bed_weight});
    row.push_back({"lowest_voidage", "1", gas->lowest_voidage});
    row.push_back({"highest_voidage", "1", gas->highest_voidage});
    row.push_back({"courant_number", "1", gas->courant_number});
    return row;
}

double weight_per_area(const CaseGas& gas, double mass)
{
    const Vector g = gas.gravity();
    if (g.norm() == 0) return 0;
    const Box box = gas.bounds();
    const double height = (box.col(1) - box.col(0)).cwiseAbs().dot(g.normalized().cwiseAbs());
    return mass * g.norm() * height / gas.total_volume();
}

Observation observe(const Communicator& comm, Solids& solids, const CaseGas* gas, const Scalars& voidage,
                    const std::vector<Vector>& pressure_taps)
{
    const ParticleView particles = solids.particles();
    const Vector up = solids.gravity().norm() > 0 ? Vector(-solids.gravity().normalized()) : Vector(0, 0, 1);

    double mass = 0, energy = 0, height = 0, momentum = 0, lowest = 1e300;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        const double m = particles.mass[column], h = particles.position.col(column).dot(up);
        mass += m;
        energy += 0.5 * m * particles.velocity.col(column).squaredNorm();
        height += m * h;
        momentum += m * particles.velocity.col(column).dot(up);
        lowest = std::min(lowest, h - particles.radius[column]);
    }
    Scalars sums{mass, energy, height, momentum, static_cast<double>(particles.size())};
    comm.sum(sums);

    Observation seen;
    seen.particles = static_cast<long>(sums[4]);
    seen.kinetic_energy = sums[1];
    if (sums[0] > 0) {
        double floor = comm.min(lowest);
        if (gas) floor = std::min(gas->bounds().col(0).dot(up), gas->bounds().col(1).dot(up));
        seen.bed_height = 2 * (sums[2] / sums[0] - floor);
        seen.vertical_velocity = sums[3] / sums[0];
    }
    if (!gas) return seen;
    double least = 1, most = 0;
    for (const double eps : voidage) {
        least = std::min(least, eps);
        most = std::max(most, eps);
    }
    Observation::OfGas& of_gas = seen.gas.emplace();
    of_gas.lowest_voidage = comm.min(least);
    of_gas.highest_voidage = comm.max(most);
    of_gas.courant_number = gas->courant_number();
    of_gas.bed_weight = weight_per_area(*gas, sums[0]);
    if (pressure_taps.size() >= 2)
        of_gas.pressure_drop = gas->pressure_at(pressure_taps[0]) - gas->pressure_at(pressure_taps.back());
    return seen;
}

}  // namespace interphase
