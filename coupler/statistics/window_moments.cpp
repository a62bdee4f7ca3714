// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/window_moments.hpp"

#include <algorithm>
#include <limits>

namespace interphase {

namespace {

constexpr int component[] = {0, 2};  // across, up

class Windows {
public:
    Windows(const SampleWindows& windows, bool front_only) : windows_(windows), front_only_(front_only)
    {
        for (std::size_t n = 0; n <= windows.windows(); ++n)
            edges_.push_back(windows.edge(n));
    }

    /// Window that holds a centre, or -1.
    int of(const Vector& x) const
    {
        const double low = windows_.low();
        if (!(x.z() >= low && x.z() < low + windows_.height)) return -1;
        if (front_only_ && !(x.y() >= windows_.front && x.y() <= windows_.front + windows_.front_depth)) return -1;
        if (!(x.x() >= edges_.front() && x.x() < edges_.back())) return -1;
        return static_cast<int>(std::upper_bound(edges_.begin(), edges_.end(), x.x()) - edges_.begin()) - 1;
    }

private:
    const SampleWindows& windows_;
    bool front_only_;
    Scalars edges_;
};

}  // namespace

WindowMoments window_moments(const Communicator& comm, const ParticleView& particles, const SampleWindows& windows,
                             bool front_only)
{
    struct Inside {
        std::size_t window, particle;
    };
    const std::size_t n = windows.windows();
    const Windows places(windows, front_only);
    std::vector<Inside> inside;
    Scalars sums(4 * n, 0.0);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const int of = places.of(particles.position.col(static_cast<Eigen::Index>(i)));
        if (of < 0) continue;
        const auto w = static_cast<std::size_t>(of);
        inside.push_back({w, i});
        const double weight = particles.weight[i];
        sums[w] += 1;
        sums[n + w] += weight;
        for (std::size_t k = 0; k < 2; ++k)
            sums[(2 + k) * n + w] += weight * particles.velocity(component[k], static_cast<Eigen::Index>(i));
    }
    comm.sum(sums);
    const auto part = [n](const Scalars& of, std::size_t k) {
        const auto first = of.begin() + static_cast<std::ptrdiff_t>(k * n);
        return Scalars(first, first + static_cast<std::ptrdiff_t>(n));
    };
    WindowMoments found{part(sums, 0), part(sums, 1), {part(sums, 2), part(sums, 3)}, {}};

    Scalars squares(2 * n, 0.0);
    for (const Inside& of : inside)
        for (std::size_t k = 0; k < 2; ++k) {
            const double mean = found.sum[k][of.window] / std::max(1.0, found.real[of.window]);
            const double v = particles.velocity(component[k], static_cast<Eigen::Index>(of.particle)) - mean;
            squares[k * n + of.window] += particles.weight[of.particle] * v * v;
        }
    comm.sum(squares);
    for (std::size_t k = 0; k < 2; ++k) {
        found.temperature[k].assign(n, std::numeric_limits<double>::quiet_NaN());
        for (std::size_t w = 0; w < n; ++w)
            if (found.number[w] >= 2) found.temperature[k][w] = squares[k * n + w] / found.real[w];
    }
    return found;
}

}  // namespace interphase
