// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "mapping/cell_graph.hpp"

namespace interphase {

/// Spreads cell contents along the faces of the mesh, as diffusion for a time would: (1 - L/s)^s on densities, where L
/// is the finite-volume Laplacian times that time, with two-point fluxes over the faces and none through boundaries
/// (Capecelatro and Desjardins, J. Comput. Phys. 238 (2013) 1; Sun and Xiao, Int. J. Multiphase Flow 77 (2015) 142).
///
/// The number of steps s is fixed by the mesh, so large that no step takes more from a cell than it has. So nothing
/// becomes negative; a uniform density stays what it is and contents stay whole to round-off, however far the diffusion
/// has gone; and the same matrix, symmetric in the inner product weighted by volumes, takes values the way back.
///
/// Many steps are made as fewer: x^s as a sum of Chebyshev polynomials, of which those of degree beyond some multiple
/// of sqrt(s) weigh less than round-off (Newman and Rivlin, SIAM J. Numer. Anal. 13 (1976) 451).
class Diffusion {
public:
    /// `half_variance(distance)`: of the spread along a link of that length [m2], at least 0; each component of a
    /// particle's displacement gets twice this variance. Collective.
    Diffusion(const CellGraph& cells, const Communicator& comm, const std::function<double(double)>& half_variance);

    /// Applications of the matrix; 0 where there is nothing to spread.
    int sweeps() const { return static_cast<int>(coefficients_.size()) - 1; }

    /// Of contents [own cells]. Collective.
    template <class Record>
    void spread(std::vector<Record>& contents) const
    {
        if (sweeps() <= 0) return;
        for (std::size_t c = 0; c < cells_.own_count(); ++c)
            numbers(contents[c]) *= 1 / cells_.volume(c);
        smooth(contents);
        for (std::size_t c = 0; c < cells_.own_count(); ++c)
            numbers(contents[c]) *= cells_.volume(c);
    }

    /// The transpose, of values [own cells]. Collective.
    template <class Record>
    void smooth(std::vector<Record>& values) const
    {
        if (sweeps() <= 0) return;
        // T_0, T_1 and so on of the matrix, applied to the values: each from the two before
        std::vector<Record> now = values, before, next;
        weigh(values, coefficients_[0]);
        for (std::size_t n = 1; n < coefficients_.size(); ++n) {
            apply(now, next);
            if (n > 1 && !powers_)
                for (std::size_t c = 0; c < cells_.own_count(); ++c)
                    numbers(next[c]) = 2 * numbers(next[c]) - numbers(before[c]);
            before.swap(now);
            now.swap(next);
            if (coefficients_[n] == 0) continue;
            for (std::size_t c = 0; c < cells_.own_count(); ++c)
                numbers(values[c]) += coefficients_[n] * numbers(now[c]);
        }
    }

private:
    static Scalars power_in_chebyshev_polynomials(int steps);

    template <class Record>
    void weigh(std::vector<Record>& values, double factor) const
    {
        for (std::size_t c = 0; c < cells_.own_count(); ++c)
            numbers(values[c]) *= factor;
    }

    /// One step. `values` has its halo filled on the way.
    template <class Record>
    void apply(std::vector<Record>& values, std::vector<Record>& next) const
    {
        values.resize(cells_.local_count());
        next.resize(cells_.local_count());
        cells_.fill_halo(values);
        for (std::size_t c = 0; c < cells_.own_count(); ++c) {
            const Numbers<Record> own = numbers(values[c]);
            Numbers<Record> sum = own;
            for (const CellGraph::Link* link = cells_.links_begin(c); link != cells_.links_end(c); ++link)
                sum += part_[cells_.link_number(link)] * (numbers(values[static_cast<std::size_t>(link->to)]) - own);
            numbers(next[c]) = sum;
        }
    }

    const CellGraph& cells_;
    Scalars part_;          ///< of each link, in one step: what its cell takes of the difference
    Scalars coefficients_;  ///< of the powers of the matrix, or of its Chebyshev polynomials
    bool powers_ = true;
};

}  // namespace interphase
