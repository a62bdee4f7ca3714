// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vector.hpp"
#include "momentum/fluid_force.hpp"
#include "momentum/particle_coupling.hpp"
#include "plugin/solid_stress.hpp"
#include "step/departure.hpp"
#include "step/particle_weights.hpp"
#include "step/periodic_box.hpp"

namespace interphase {

/// The particles a rank owns [n]; valid until the solids advance. Radius [m] and mass [kg] are those of the tracked
/// sphere.
struct ParticleView {
    VectorsView position;
    VectorsView velocity;
    VectorsView angular_velocity;
    VectorsView force;
    ScalarsView radius;
    ScalarsView mass;
    ParticleWeights weight;
    const int* id;
    const int* type;    ///< as the script counts them, from 1
    FluidForce* fluid;  ///< null in a run without gas, as the next two
    double* booked;     ///< sum of the fluid force over the substeps since the gas solve [n x 3, N]
    ParticleCoupling* coupling;

    Vector booked_force(std::size_t i) const { return Eigen::Map<const Vector>(booked + 3 * i); }
    std::size_t size() const { return static_cast<std::size_t>(position.cols()); }
};

/// What moves the particles. In every substep it lets each FluidForce act on the sum of all other forces.
class Solids {
public:
    virtual ~Solids() = default;
    virtual ParticleView particles() = 0;
    virtual Vector gravity() const = 0;  ///< [m/s2]
    virtual PeriodicBox periods() const { return {}; }

    /// How a substep goes: half a kick by the forces that `particles` shows, then the drift (velocity Verlet,
    /// LIGGGHTS's own integrators), or the drift first.
    virtual bool kicks_before_moving() const { return true; }

    /// Whether a gas step of one substep may begin with the forces of its own gas: the kick that the last step began is
    /// taken back, and made again by kick_again().
    virtual bool takes_new_forces() const { return false; }
    /// Sets velocity [m/s] and force [N] of particle `i`.
    virtual void kick_again(std::size_t /*i*/, const Vector& /*velocity*/, const Vector& /*force*/) {}

    /// The particles that left in the last advance(), each on one rank.
    virtual const std::vector<Departure>& departures() const = 0;
    /// Those that were made in it and are there now: their numbers on this rank, as particles() counts.
    virtual const std::vector<std::size_t>& arrivals() const = 0;
    /// Radii that particles still to be made will have, the smallest and the largest of each kind [m]; the same on all
    /// ranks.
    virtual Scalars radii_to_come() const { return {}; }

    /// The model that wants a stress of the solids on the gas mesh, or null.
    virtual SolidStress* solid_stress() { return nullptr; }

    /// Collective.
    virtual void advance(int substeps) = 0;
};

}  // namespace interphase
