// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "step/gas.hpp"
#include "support/box_mesh.hpp"

namespace interphase::test {

/// A gas whose cells do not feel each other: in each,
///     M du/dt = V (source - rate u) + V body_force - (eps + following) V grad p,  u implicit in the drag,
/// with grad p the same everywhere. Its momentum is known exactly.
class BoxGas : public Gas {
public:
    BoxGas(const Communicator& comm, const BoxMesh& mesh, double density, double viscosity);

    const MeshView& mesh() const override { return mesh_.view(); }
    const CellLocator& locator() const override { return mesh_; }
    GasProperty density() const override { return density_; }
    GasProperty viscosity() const override { return viscosity_; }
    void set_voidage(const Scalars& voidage) override { voidage_ = voidage; }
    void solve(double dt, const Demand& demand) override;
    Scalars outflow() const override { return Scalars(voidage_.size(), 0.0); }
    Crossing crossing() const override { return {}; }
    Scalars velocity() const override { return velocity_; }
    Scalars pressure_gradient() const override;
    Scalars velocity_gradient() const override { return velocity_gradient_; }
    Scalars viscous_force() const override { return viscous_force_; }
    /// Green-Gauss with values linear between the centres: OpenFOAM's `Gauss linear`.
    Scalars gradient(const Scalars& of_cells) const override;
    Scalars stretching(const Scalars& flow) const override;
    void write_along(const std::vector<CellField>& fields) override { written_along = fields; }
    std::optional<Problem> trouble() const override { return trouble_; }

    std::vector<CellField> written_along;  ///< as given last

    /// Everywhere [m/s].
    void set_velocity(const Vector& u);
    /// That of one of this rank's cells [m/s].
    void set_velocity(std::size_t cell, const Vector& u);
    Vector velocity_in(std::size_t cell) const { return Eigen::Map<const Vector>(&velocity_[3 * cell]); }
    /// Mass per volume that the momentum balance sees [kg/m3]; the gas density at first. Not what drag laws see.
    void set_inertia(double mass_per_volume) { inertia_ = mass_per_volume; }
    /// Whatever the particles do, the velocity stays.
    void hold_velocity() { held_ = true; }
    void set_body_force(const Vector& per_volume) { body_force_ = per_volume; }   ///< [N/m3]
    void set_pressure_gradient(const Vector& gradient) { gradient_ = gradient; }  ///< [Pa/m]
    /// Everywhere: d u_j/d x_i in row i, column j [1/s]; says nothing of the velocity.
    void set_velocity_gradient(const Eigen::Matrix3d& gradient);
    void set_viscous_force(const Vector& per_volume);  ///< everywhere [N/m3]
    /// Of each of this rank's cells, as drag laws see them [kg/m3, Pa s].
    void set_properties(const GasProperty& density, const GasProperty& viscosity)
    {
        density_ = density;
        viscosity_ = viscosity;
    }
    void set_trouble(const Problem& problem) { trouble_ = problem; }

    Vector momentum() const;  ///< of all ranks [kg m/s]. Collective.
    double mass() const;      ///< Collective.
    double volume() const;    ///< Collective.
    const Scalars& voidage() const { return voidage_; }
    const Scalars& surplus() const { return surplus_; }  ///< that the last step was asked for [n, 1/s]

private:
    Communicator comm_;
    const BoxMesh& mesh_;
    GasProperty density_, viscosity_;
    double inertia_;
    bool held_ = false;
    Scalars velocity_;
    Scalars voidage_, surplus_;
    Scalars velocity_gradient_, viscous_force_;
    Vector body_force_ = Vector::Zero();
    Vector gradient_ = Vector::Zero();
    std::optional<Problem> trouble_;
};

}  // namespace interphase::test
