// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "step/coupling_step.hpp"
#include "support/box_gas.hpp"
#include "support/point_particles.hpp"

namespace interphase::test {

/// A coupling step with everything it needs: a gas in a box, point particles, the rules between them.
class Scene {
public:
    /// `all`: the particles of all ranks, the same list on each. Particle n lives on rank n modulo the number of ranks,
    /// so that the two decompositions have little in common.
    Scene(const Communicator& comm, const BoxMesh::Planes& planes, double gas_density, double viscosity,
          const std::vector<Particle>& all, const Vector& gravity, double solid_step, const Settings& rules,
          SolidStress* stress = nullptr)
        : settings(rules),
          mesh(comm, planes, 2),
          gas(comm, mesh, gas_density, viscosity),
          particles(comm, share_of(comm, all), gravity, solid_step, stress),
          step(comm, settings, gas, particles, stopwatch),
          solid_step_(solid_step)
    {}

    Scene(const Scene&) = delete;  // its parts refer to each other
    Scene& operator=(const Scene&) = delete;

    /// What the step has counted under this name, on all ranks. Collective.
    long counted(const std::string& key) const
    {
        const std::vector<Count> all = step.counts();
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const Count& count) { return count.kind->key == key; });
        if (found == all.end()) throw std::out_of_range("nothing is counted as " + key);
        return found->number;
    }

    void advance(int substeps) { step.advance(substeps * solid_step_, substeps); }

    const Settings settings;
    BoxMesh mesh;
    BoxGas gas;
    PointParticles particles;
    Stopwatch stopwatch{Phase::setup};
    CouplingStep step;

private:
    static std::vector<Particle> share_of(const Communicator& comm, const std::vector<Particle>& all)
    {
        std::vector<Particle> mine;
        for (std::size_t n = 0; n < all.size(); ++n)
            if (static_cast<int>(n) % comm.size() == comm.rank()) mine.push_back(all[n]);
        return mine;
    }

    double solid_step_;
};

}  // namespace interphase::test
