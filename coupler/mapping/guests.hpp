// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/communicator.hpp"
#include "base/numbers.hpp"
#include "exchange/exchange_plan.hpp"
#include "mapping/mesh_view.hpp"
#include "mapping/straight_paths.hpp"

namespace interphase {

/// Points of this rank's particles that lie beyond a face to another rank or a cyclic pair, and those that have come to
/// this rank so: its guests, whose records stand behind those of its particles.
class Guests {
public:
    Guests(const Communicator& comm, const MeshView& mesh, const StraightPaths& paths);

    /// A point of a particle, of that share, on its way.
    struct Point {
        StraightPaths::Path path;
        double share;
        int rank;      ///< the particle's
        int particle;  ///< its number there
        int size_class;
    };

    /// A point whose path leaves this rank through `face`.
    void leave(int face, const Point& point);

    /// Follows all that have left to their ends. Returns those that have arrived on this rank, with their own numbers,
    /// from `particles` on, for `particle`. Collective.
    std::vector<Point> arrive(std::size_t particles);

    std::size_t count() const { return wanted_; }

    /// The particles' records with those of the guests behind. Collective.
    template <class Record>
    std::vector<Record> with_guests(std::vector<Record> of_particles) const
    {
        std::vector<Record> out;
        for (const std::size_t particle : served_)
            out.push_back(of_particles[particle]);
        const std::vector<Record> in = exchange_.backward(std::move(out));
        of_particles.insert(of_particles.end(), in.begin(), in.end());
        return of_particles;
    }

    /// Adds what the guests have got, behind the particles, to the particles they belong to, and drops them.
    /// Collective.
    template <class Record>
    void send_home(std::vector<Record>& values) const
    {
        const auto guests = values.end() - static_cast<std::ptrdiff_t>(wanted_);
        const std::vector<Record> in = exchange_.forward(std::vector<Record>(guests, values.end()));
        values.resize(values.size() - wanted_);
        for (std::size_t i = 0; i < served_.size(); ++i)
            numbers(values[served_[i]]) += numbers(in[i]);
    }

    std::size_t bytes_sent() const { return exchange_.bytes_sent(); }

private:
    struct OnItsWay {
        int to_rank, face, rank, particle, size_class;
        double share, at[3], to[3];
    };

    Communicator comm_;
    const MeshView& mesh_;
    const StraightPaths& paths_;
    std::vector<OnItsWay> leaving_;
    ExchangePlan exchange_;            ///< from guests to their particles' ranks
    std::size_t wanted_ = 0;           ///< guests of this rank
    std::vector<std::size_t> served_;  ///< own particles with guests elsewhere, ordered by rank
};

}  // namespace interphase
