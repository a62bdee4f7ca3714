// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/bed_surface.hpp"

#include <cmath>
#include <limits>

#include "statistics/bins.hpp"

namespace interphase {

namespace {

constexpr std::size_t bins = 512;

std::size_t within(double place, std::size_t count)
{
    return static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, static_cast<double>(count - 1)));
}

}  // namespace

BedSurface::BedSurface(const Box& vessel, std::size_t columns, double share)
    : edges_(even_edges(vessel(0, 0), vessel(0, 1), columns)),
      low_(vessel(2, 0)),
      bin_((vessel(2, 1) - vessel(2, 0)) / static_cast<double>(bins)),
      share_(share)
{}

std::size_t BedSurface::column_at(double x) const
{
    const std::size_t columns = edges_.size() - 1;
    return within((x - edges_.front()) / (edges_.back() - edges_.front()) * static_cast<double>(columns), columns);
}

Scalars BedSurface::heights(const Communicator& comm, const ParticleView& particles) const
{
    const std::size_t columns = edges_.size() - 1;
    Scalars solids(columns * bins, 0.0);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        const Vector x = particles.position.col(at);
        const double r = particles.radius[at];
        solids[column_at(x.x()) * bins + within((x.z() - low_) / bin_, bins)] += r * r * r;
    }
    comm.sum(solids);
    Scalars heights(columns, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t k = 0; k < columns; ++k) {
        const double* of = &solids[k * bins];
        double all = 0, below = 0;
        for (std::size_t n = 0; n < bins; ++n)
            all += of[n];
        if (all == 0) continue;
        std::size_t n = 0;
        while (n + 1 < bins && below + of[n] < share_ * all)
            below += of[n++];
        heights[k] = low_ + bin_ * (static_cast<double>(n) + (share_ * all - below) / of[n]);
    }
    return heights;
}

double mean_height(const Scalars& heights)
{
    double sum = 0, number = 0;
    for (const double height : heights)
        if (std::isfinite(height)) {
            sum += height;
            ++number;
        }
    return sum / number;  // NaN for none
}

}  // namespace interphase
