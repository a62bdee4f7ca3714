// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "exchange/cell_locator.hpp"
#include "mapping/mesh_view.hpp"

namespace interphase {

/// The gas on this rank's cells [n]. Cell vectors are flat, [n x 3].
class Gas {
public:
    virtual ~Gas() = default;

    virtual const MeshView& mesh() const = 0;
    virtual const CellLocator& locator() const = 0;
    virtual double density() const = 0;    ///< [kg/m3]
    virtual double viscosity() const = 0;  ///< [Pa s]

    /// The voidage at the start of the coming step [n]; its rate of change follows from the last one.
    virtual void set_voidage(const Scalars& voidage) = 0;

    /// Advances by `dt` [s] with the force source - rate * u [N/m3] on the gas, u implicit. `rate` [n, kg/(m3 s)],
    /// `source` [n x 3, N/m3]. Collective.
    virtual void solve(double dt, const Scalars& rate, const Scalars& source) = 0;

    virtual Scalars velocity() const = 0;           ///< [n x 3, m/s]
    virtual Scalars pressure_gradient() const = 0;  ///< of the full pressure [n x 3, Pa/m]

    /// Gradient of any quantity of the cells [n, q], without slope at the boundaries [n x 3, q/m]. Collective.
    virtual Scalars gradient(const Scalars& of_cells) const = 0;

    /// Of a flow q of the cells [n x 3] that stops at every boundary: dq_x/dx, dq_y/dy, dq_z/dz, apart [n x 3, q/m].
    /// Collective.
    virtual Scalars stretching(const Scalars& flow) const = 0;

    /// What is wrong with the fields of this rank, if anything (a value that is not finite: field, cell, place).
    virtual std::optional<std::string> trouble() const = 0;
};

}  // namespace interphase
