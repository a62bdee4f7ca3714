// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/problem.hpp"
#include "exchange/cell_locator.hpp"
#include "mapping/mesh_view.hpp"

namespace interphase {

/// What the solids ask of the gas in one step, on this rank's cells [n]; vectors are flat, [n x 3].
///
/// On the gas acts source - rate * u [N/m3], and the gradient of the full pressure on the share voidage + following of
/// the volume; the solids' own flux over the step is flux + moving * u - mobility * grad p [m/s], all of it with u and
/// grad p of the end of the step.
struct Demand {
    explicit Demand(std::size_t cells)
        : gas_share(cells, 1.0),
          rate(cells, 0.0),
          source(3 * cells, 0.0),
          following(cells, 0.0),
          moving(cells, 0.0),
          mobility(cells, 0.0),
          flux(3 * cells, 0.0),
          surplus(cells, 0.0)
    {}

    Scalars gas_share;  ///< volume of gas there is, by what has flowed in and out, over that of the cell
    Scalars rate;       ///< [kg/(m3 s)]
    Scalars source;     ///< [n x 3, N/m3]
    Scalars following;  ///< solid volume whose pressure force drag gives back, a share of the whole volume, 0 to 1
    Scalars moving;     ///< solid volume that moves as the gas does, likewise
    Scalars mobility;   ///< [m3 s/kg]
    Scalars flux;       ///< [n x 3, m/s]
    Scalars surplus;    ///< gas volume that has to leave beside what the solids push out, per volume and time [1/s]
};

/// Gas volume that crossed the outer boundary of this rank's part in a step [m3].
struct Crossing {
    double in = 0, out = 0;
};

/// A face of the outer boundary that gas may pass.
struct OpenFace {
    int cell;         ///< behind it
    Vector outwards;  ///< unit normal vector
};

/// A property of the gas: the same everywhere, or that of each of this rank's cells [n].
struct GasProperty {
    GasProperty(double everywhere) : uniform(everywhere) {}
    GasProperty(Scalars of_each_cell) : of_cells(std::move(of_each_cell)) {}

    bool varies() const { return !of_cells.empty(); }
    double in(std::size_t cell) const { return varies() ? of_cells[cell] : uniform; }

    double uniform = 0;
    Scalars of_cells;  ///< empty where it is uniform
};

/// A quantity of this rank's cells, for the gas's files.
struct CellField {
    std::string name;
    Scalars values;  ///< [n], or [n x 3] of a vector, in the unit (m/s)^velocities
    int velocities;
    bool vector;
};

/// The gas on this rank's cells [n]. Cell vectors are flat, [n x 3].
class Gas {
public:
    virtual ~Gas() = default;

    virtual const MeshView& mesh() const = 0;
    virtual const CellLocator& locator() const = 0;
    /// By how far cyclic pairs move what passes them, each way once [m]; the same on all ranks.
    virtual Vectors translations() const { return {}; }
    virtual GasProperty density() const = 0;    ///< [kg/m3]
    virtual GasProperty viscosity() const = 0;  ///< dynamic [Pa s]

    /// The voidage at the start of the coming step [n].
    virtual void set_voidage(const Scalars& voidage) = 0;

    /// Advances by `dt` [s], so that gas and solids together keep the volume: per cell, the gas that leaves and the
    /// solids that leave are the surplus. Collective.
    virtual void solve(double dt, const Demand& demand) = 0;

    /// Gas volume that left each cell in the last step, net [n, m3].
    virtual Scalars outflow() const = 0;
    virtual Crossing crossing() const = 0;  ///< in the last step
    /// Inlets and outlets of this rank's part.
    virtual std::vector<OpenFace> open_faces() const { return {}; }

    virtual Scalars velocity() const = 0;           ///< [n x 3, m/s]
    virtual Scalars pressure_gradient() const = 0;  ///< of the full pressure [n x 3, Pa/m]

    /// d u_j/d x_i at 9 c + 3 i + j of the gas velocity [n x 9, 1/s]. Collective.
    virtual Scalars velocity_gradient() const = 0;
    /// div tau of the gas alone [n x 3, N/m3]. Collective.
    virtual Scalars viscous_force() const = 0;

    /// Gradient of any quantity of the cells [n, q], without slope at the boundaries [n x 3, q/m]. Collective.
    virtual Scalars gradient(const Scalars& of_cells) const = 0;

    /// Of a flow q of the cells [n x 3] that stops at every boundary: dq_x/dx, dq_y/dy, dq_z/dz, apart [n x 3, q/m].
    /// Collective.
    virtual Scalars stretching(const Scalars& flow) const = 0;

    /// Whenever its own fields are written, these are, too; each call sets the values of those it names. Collective.
    virtual void write_along(const std::vector<CellField>& fields) = 0;

    /// What is wrong with the fields of this rank, if anything (a value that is not finite: field, cell, place).
    virtual std::optional<Problem> trouble() const = 0;
};

}  // namespace interphase
