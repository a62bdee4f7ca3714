// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/diffusion.hpp"

#include <cmath>

namespace interphase {

Diffusion::Diffusion(const CellGraph& cells, const Communicator& comm,
                     const std::function<double(double)>& half_variance)
    : cells_(cells)
{
    double most = 0;  // what a cell would give away in one step
    for (std::size_t c = 0; c < cells.own_count(); ++c) {
        double given = 0;
        for (const CellGraph::Link* link = cells.links_begin(c); link != cells.links_end(c); ++link) {
            part_.push_back(link->openness * half_variance(link->distance) / cells.volume(c));
            given += part_.back();
        }
        most = std::max(most, given);
    }
    most = comm.max(most);
    // Where cells are as wide as the width asked for, round-off alone would be spread, at the cost of a sweep.
    constexpr double negligible = 1e-6;
    if (!(most > negligible)) return;

    // Two thirds at most in one step: then cells that fill and empty in turn, which a step of all would leave so, calm.
    // Round-off, which differs with the number of ranks, must not make one more of them.
    const int steps = std::max(1, static_cast<int>(std::ceil(1.5 * most - 1e-6)));
    for (double& part : part_)
        part /= steps;
    const Scalars polynomials = power_in_chebyshev_polynomials(steps);
    powers_ = static_cast<int>(polynomials.size()) > steps;
    if (powers_) {
        coefficients_.assign(static_cast<std::size_t>(steps) + 1, 0.0);
        coefficients_.back() = 1.0;
    } else
        coefficients_ = polynomials;
}

Scalars Diffusion::power_in_chebyshev_polynomials(int steps)
{
    // x^s = 2^(1-s) sum_j C(s, (s-j)/2) T_j(x) over j of the parity of s, half of it for j = 0
    constexpr double negligible = 1e-15;
    Scalars coefficients(static_cast<std::size_t>(steps) + 1, 0.0);
    double sum = 0;
    std::size_t last = 0;
    for (int j = steps % 2; j <= steps; j += 2) {
        const double log_binomial =
            std::lgamma(steps + 1.0) - std::lgamma((steps - j) / 2 + 1.0) - std::lgamma((steps + j) / 2 + 1.0);
        const double coefficient = (j > 0 ? 2.0 : 1.0) * std::exp(log_binomial - steps * std::log(2.0));
        if (coefficient < negligible) break;
        coefficients[static_cast<std::size_t>(j)] = coefficient;
        sum += coefficient;
        last = static_cast<std::size_t>(j);
    }
    coefficients.resize(last + 1);
    for (double& coefficient : coefficients)
        coefficient /= sum;
    return coefficients;
}

}  // namespace interphase
