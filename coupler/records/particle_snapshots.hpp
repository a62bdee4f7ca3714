// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/communicator.hpp"
#include "records/twin_file.hpp"

namespace interphase {

/// The particles of one rank at one time, as they are recorded: [n] ids and types, flat [n x 3] vectors, diameters and
/// densities of the tracked spheres [n] and, where they differ (on all ranks or on none), their weights [n]. SI units.
struct ParticleRows {
    std::vector<int> id, type;
    Scalars position, velocity, angular_velocity, force, diameter, density;
    std::optional<Scalars> weight;
};

/// Writes particles.h5, in which each time is a group /snapshots/NNNNNN, and particles.xdmf, which ParaView opens. All
/// ranks write their own rows; no rank gathers them.
///
/// A group is a link to snapshots/NNNNNN.h5, a file that is complete before it gets its name; link and xdmf follow. A
/// run that is killed at any moment has whole snapshots only.
class ParticleSnapshots {
public:
    /// What was there before goes; where the run goes on from a time [s], only the snapshots after it, with the next
    /// one that is written. Collective.
    explicit ParticleSnapshots(const Communicator& comm, std::optional<double> goes_on_from = std::nullopt);

    /// Collective.
    void write(double time, const ParticleRows& rows);

    /// When the last one was written [s]; nothing before the first.
    std::optional<double> last() const { return last_; }

private:
    void take_up(double time);
    void drop_later_ones();
    void write_scene() const;
    void write_xdmf(int number, std::size_t particles, double time, bool with_weights);

    Communicator comm_;
    const std::string part_;         ///< ending of a file's name until it is complete
    std::optional<TwinFile> index_;  ///< on rank 0
    int count_ = 0;
    std::optional<double> last_;
    std::vector<std::string> later_;  ///< names of links to snapshots that go with the next one
    std::string grids_;               ///< the part of the XDMF that lists the snapshots
};

}  // namespace interphase
