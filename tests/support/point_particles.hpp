// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/communicator.hpp"
#include "step/solids.hpp"

namespace interphase::test {

struct Particle {
    int id = 1;
    Vector position = Vector::Zero();
    Vector velocity = Vector::Zero();
    double diameter = 1e-3;  ///< [m]
    double density = 1000;   ///< [kg/m3]
    double weight = 1;       ///< real particles in it
    bool held = false;       ///< by rigid contacts, where it is
};

/// Particles that do not touch each other, moved by the velocity Verlet steps of LIGGGHTS's integrator: half a kick
/// with the last substep's force, a drift, the forces (the fluid's last, as its fix does), half a kick. A held particle
/// feels the contact force that keeps it at rest.
class PointParticles : public Solids {
public:
    PointParticles(const Communicator& comm, const std::vector<Particle>& mine, const Vector& gravity,
                   double solid_step, SolidStress* stress = nullptr);

    ParticleView particles() override;
    Vector gravity() const override { return gravity_; }
    const std::vector<Departure>& departures() const override { return departures_; }
    const std::vector<std::size_t>& arrivals() const override { return arrivals_; }
    SolidStress* solid_stress() override { return stress_; }
    void advance(int substeps) override;

    std::size_t size() const { return id_.size(); }
    Vector position(std::size_t i) const { return position_.col(column(i)); }
    Vector velocity(std::size_t i) const { return velocity_.col(column(i)); }
    int id(std::size_t i) const { return id_[i]; }

    void set_velocity(std::size_t i, const Vector& v) { velocity_.col(column(i)) = v; }

    /// Lets the particle vanish at the end of the next advance(): without a word, unless removal is allowed.
    void remove_next(int id) { doomed_ = id; }
    /// Makes one on this rank in the next advance(), before its first substep.
    void insert_next(const Particle& particle) { coming_.push_back(particle); }
    /// Lets the particle's velocity, and its position if asked, become not a number in the next advance().
    void break_next(int id, bool position_too)
    {
        broken_ = id;
        breaks_position_ = position_too;
    }
    void set_weight(std::size_t i, double weight) { weight_[column(i)] = weight; }
    void allow_removal(Exit exit = Exit::mesh)
    {
        may_remove_ = true;
        exit_ = exit;
    }

    /// Momentum of the particles that move, with the half kick of the fluid force that the next substep begins with, so
    /// that it holds the whole impulse taken [kg m/s]. Collective.
    Vector momentum() const;

    /// What held particles took from the gas so far, and their contacts from them [kg m/s]. Collective.
    Vector impulse_on_held() const { return comm_.sum(impulse_on_held_); }

    /// Taken in the last gas step less what the gas solve assumed: what the gas still owes [kg m/s]. Collective.
    Vector pending() const;

private:
    static Eigen::Index column(std::size_t i) { return static_cast<Eigen::Index>(i); }
    void add_forces(std::size_t i);
    void erase(std::size_t i);
    void append(const Particle& particle);
    Departure departure_of(std::size_t i) const;

    Communicator comm_;
    Vector gravity_;
    double solid_step_;
    Eigen::Matrix3Xd position_, velocity_, spin_, force_, fluid_force_;
    Eigen::VectorXd radius_, mass_, weight_;
    std::vector<int> id_, type_;
    std::vector<bool> held_;
    std::vector<FluidForce> fluid_;
    Scalars booked_;
    std::vector<ParticleCoupling> coupling_;
    Vector impulse_on_held_ = Vector::Zero();
    SolidStress* stress_ = nullptr;
    int doomed_ = -1;
    int broken_ = -1;
    bool breaks_position_ = false;
    bool may_remove_ = false;
    Exit exit_ = Exit::mesh;
    std::vector<Particle> coming_;
    std::vector<Departure> departures_;
    std::vector<std::size_t> arrivals_;
};

}  // namespace interphase::test
