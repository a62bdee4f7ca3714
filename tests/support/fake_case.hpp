// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "run/gas_case.hpp"
#include "run/particle_engine.hpp"
#include "support/box_gas.hpp"
#include "support/fake_dictionary.hpp"
#include "support/methods.hpp"
#include "support/point_particles.hpp"

namespace interphase::test {

/// A BoxGas as the gas of a case.
class FakeCaseGas : public CaseGas {
public:
    FakeCaseGas(const Communicator& comm, const BoxMesh& mesh, const Vector& gravity)
        : box(comm, mesh, 1.2, 1.8e-5), mesh_(mesh), gravity_(gravity)
    {}

    BoxGas box;
    double courant = 0;  ///< what the step before is said to have had
    std::function<void()> on_solve = [] {};

    const MeshView& mesh() const override { return box.mesh(); }
    const CellLocator& locator() const override { return box.locator(); }
    GasProperty density() const override { return box.density(); }
    GasProperty viscosity() const override { return box.viscosity(); }
    void set_voidage(const Scalars& voidage) override { box.set_voidage(voidage); }
    void solve(double dt, const Demand& demand) override
    {
        on_solve();
        box.solve(dt, demand);
    }
    Scalars outflow() const override { return box.outflow(); }
    Crossing crossing() const override { return box.crossing(); }
    Scalars velocity() const override { return box.velocity(); }
    Scalars pressure_gradient() const override { return box.pressure_gradient(); }
    Scalars velocity_gradient() const override { return box.velocity_gradient(); }
    Scalars viscous_force() const override { return box.viscous_force(); }
    Scalars gradient(const Scalars& of_cells) const override { return box.gradient(of_cells); }
    Scalars stretching(const Scalars& flow) const override { return box.stretching(flow); }
    void write_along(const std::vector<CellField>& fields) override { box.write_along(fields); }
    std::optional<Problem> trouble() const override { return box.trouble(); }

    double courant_number() const override { return courant; }
    double pressure_at(const Vector& point) const override { return -10 * point.z(); }
    double total_volume() const override { return box.volume(); }
    Box bounds() const override { return mesh_.whole(); }
    Vector gravity() const override { return gravity_; }
    void keep(Archive&) override { throw std::logic_error("a fake gas keeps nothing"); }

private:
    const BoxMesh& mesh_;
    Vector gravity_;
};

/// A case that is in no folder: its clock, its dictionary, and what was asked of it.
class FakeCase : public GasCase {
public:
    FakeCase(const Communicator& comm, const BoxMesh& mesh) : comm_(comm), mesh_(mesh) {}

    FakeDictionary coupling{{}}, parameters{{}};
    double start = 0, end = 0.1, step = 0.01, now = 0;
    bool adjusts = false;
    double largest_courant = 1, largest_step = 1e300;
    Vector gravity = Vector(0, 0, -9.81);
    double write_interval = 1e300;
    std::vector<double> steps;    ///< that were made [s]
    std::vector<double> written;  ///< times at which the fields were written [s]
    FakeCaseGas* gas = nullptr;   ///< once it was made
    std::function<void(FakeCaseGas&)> prepare = [](FakeCaseGas&) {};

    const Dictionary& coupling_dict() const override { return coupling; }
    const Dictionary& scene_parameters() const override { return parameters; }
    std::unique_ptr<CaseGas> make_gas(const Settings&) override
    {
        auto made = std::make_unique<FakeCaseGas>(comm_, mesh_, gravity);
        gas = made.get();
        prepare(*gas);
        return made;
    }
    std::string name() const override { return "fake"; }
    std::string engine() const override { return "BoxGas 1"; }
    double time() const override { return now; }
    double end_time() const override { return end; }
    double gas_step() const override { return step; }
    bool adjusts_gas_step() const override { return adjusts; }
    double largest_courant_number() const override { return largest_courant; }
    double largest_gas_step() const override { return largest_step; }
    bool running() override { return now < end - 1e-9; }
    void advance_time(double by) override
    {
        steps.push_back(by);
        now += by;
    }
    void stop() override { end = now; }
    bool write_due() const override
    {
        const double times = now / write_interval;
        return std::abs(times - std::round(times)) * write_interval < 0.5 * step && std::round(times) > 0;
    }
    void keep(Archive& archive) override { archive.keep("now", now); }
    void write() override { written.push_back(now); }
    void with_own_errors(const std::function<void()>& body) const override { body(); }

private:
    Communicator comm_;
    const BoxMesh& mesh_;
};

/// PointParticles as an engine.
class FakeEngine : public ParticleEngine {
public:
    FakeEngine(const Communicator& comm, std::vector<Particle> mine, const Vector& gravity)
        : comm_(comm), mine_(std::move(mine)), gravity_(gravity), points_(comm, mine_, gravity, 1)
    {}

    std::optional<double> collision_time, limit;
    Scalars to_come;               ///< radii [m]
    std::vector<Particle> coming;  ///< on this rank, in the next advance()
    std::vector<int> advances;     ///< substeps of each
    std::vector<long> steps_left;  ///< as told when the end moved

    std::string version() const override { return "PointParticles 1"; }
    std::string plugins() const override { return "none"; }
    std::optional<double> contact_duration() const override { return collision_time; }
    std::optional<double> step_limit() const override { return limit; }
    double largest_diameter() const override { return diameter(); }
    double smallest_diameter() const override { return diameter(); }
    void go_on_from(Archive&, double) override { throw std::logic_error("a fake engine keeps nothing"); }
    void keep(Archive&) override { throw std::logic_error("a fake engine keeps nothing"); }
    std::optional<Problem> cannot_be_kept() const override { return Problem{"a fake engine keeps nothing", "", ""}; }
    void start(double solid_step, long, bool) override { points_ = PointParticles(comm_, mine_, gravity_, solid_step); }
    void end_after(long steps) override { steps_left.push_back(steps); }
    ParticleView particles() override { return points_.particles(); }
    Vector gravity() const override { return gravity_; }
    const std::vector<Departure>& departures() const override { return points_.departures(); }
    const std::vector<std::size_t>& arrivals() const override { return points_.arrivals(); }
    Scalars radii_to_come() const override { return to_come; }
    void advance(int substeps) override
    {
        advances.push_back(substeps);
        for (const Particle& particle : coming)
            points_.insert_next(particle);
        coming.clear();
        points_.advance(substeps);
    }

private:
    double diameter() const
    {
        const double here = comm_.max(mine_.empty() ? 0.0 : mine_.front().diameter);
        return here > 0 || to_come.empty() ? here : 2 * to_come.front();
    }

    Communicator comm_;
    std::vector<Particle> mine_;
    Vector gravity_;
    PointParticles points_;
};

/// Makes one, with the methods of FakeMethods.
class FakeMaker : public ParticleEngineMaker {
public:
    using Make = std::function<std::unique_ptr<FakeEngine>(const Communicator&)>;
    explicit FakeMaker(Make make) : make_(std::move(make)) {}

    Methods methods(const std::vector<std::string>& plugins) const override { return methods_.methods(plugins); }
    std::string plugin_with(const std::string& method) const override { return methods_.plugin_with(method); }
    std::unique_ptr<ParticleEngine> make(const Communicator& comm, const Settings&) const override
    {
        return make_(comm);
    }

private:
    FakeMethods methods_;
    Make make_;
};

}  // namespace interphase::test
