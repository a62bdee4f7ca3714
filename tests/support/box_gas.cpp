// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/box_gas.hpp"

#include <numeric>

namespace interphase::test {

BoxGas::BoxGas(const Communicator& comm, const BoxMesh& mesh, double density, double viscosity)
    : comm_(comm),
      mesh_(mesh),
      density_(density),
      viscosity_(viscosity),
      inertia_(density),
      velocity_(3 * mesh.view().size(), 0.0),
      voidage_(mesh.view().size(), 1.0),
      velocity_gradient_(9 * mesh.view().size(), 0.0),
      viscous_force_(3 * mesh.view().size(), 0.0)
{}

void BoxGas::solve(double dt, const Demand& demand)
{
    surplus_ = demand.surplus;
    if (held_) return;
    for (std::size_t c = 0; c < voidage_.size(); ++c)
        for (int axis = 0; axis < 3; ++axis) {
            double& u = velocity_[3 * c + static_cast<std::size_t>(axis)];
            const double force = demand.source[3 * c + static_cast<std::size_t>(axis)] + body_force_[axis] -
                                 (voidage_[c] + demand.following[c]) * gradient_[axis];
            u = (inertia_ * u + dt * force) / (inertia_ + dt * demand.rate[c]);
        }
}

Scalars BoxGas::pressure_gradient() const
{
    Scalars flat;
    for (std::size_t c = 0; c < voidage_.size(); ++c)
        flat.insert(flat.end(), gradient_.data(), gradient_.data() + 3);
    return flat;
}

Scalars BoxGas::gradient(const Scalars& of_cells) const
{
    Scalars all(mesh_.global_count(), 0.0);
    for (std::size_t c = 0; c < of_cells.size(); ++c)
        all[mesh_.global_number(c)] = of_cells[c];
    comm_.sum(all);
    return mesh_.gradient(all);
}

Scalars BoxGas::stretching(const Scalars& flow) const
{
    Scalars diagonal(flow.size());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Scalars all(mesh_.global_count(), 0.0);
        for (std::size_t c = 0; c < voidage_.size(); ++c)
            all[mesh_.global_number(c)] = flow[3 * c + axis];
        comm_.sum(all);
        const Scalars of_component = mesh_.gradient(all, 0.0);
        for (std::size_t c = 0; c < voidage_.size(); ++c)
            diagonal[3 * c + axis] = of_component[3 * c + axis];
    }
    return diagonal;
}

void BoxGas::set_velocity(const Vector& u)
{
    for (std::size_t c = 0; c < voidage_.size(); ++c)
        set_velocity(c, u);
}

void BoxGas::set_velocity(std::size_t cell, const Vector& u) { std::copy_n(u.data(), 3, &velocity_[3 * cell]); }

void BoxGas::set_velocity_gradient(const Eigen::Matrix3d& gradient)
{
    for (std::size_t c = 0; c < voidage_.size(); ++c)
        for (int entry = 0; entry < 9; ++entry)
            velocity_gradient_[9 * c + static_cast<std::size_t>(entry)] = gradient(entry / 3, entry % 3);
}

void BoxGas::set_viscous_force(const Vector& per_volume)
{
    for (std::size_t c = 0; c < voidage_.size(); ++c)
        set_vector_at(viscous_force_, c, per_volume);
}

Vector BoxGas::momentum() const
{
    Vector sum = Vector::Zero();
    for (std::size_t c = 0; c < voidage_.size(); ++c)
        sum += inertia_ * mesh_.view().volume[c] * velocity_in(c);
    return comm_.sum(sum);
}

double BoxGas::volume() const
{
    const Scalars& volumes = mesh_.view().volume;
    return comm_.sum(std::accumulate(volumes.begin(), volumes.end(), 0.0));
}

double BoxGas::mass() const { return inertia_ * volume(); }

}  // namespace interphase::test
