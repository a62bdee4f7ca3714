# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene in numbers, as a short run of it has set it up: its particles, cells, gas, and what these are to each other."""

from dataclasses import dataclass
from typing import Optional

import numpy

from interphase import gas_fields, gas_mesh
from interphase.case_folder import Dictionaries
from interphase.drag_laws import LAWS
from interphase.fluidization import LOOSE_VOIDAGE, Grain
from interphase.input_error import InputError
from interphase.particle_script import particle_source

LAWS_OF_MIXTURES = {"BVKPolydisperse": "BVK"}  # the same law where all are of the mean size


@dataclass(frozen=True)
class PlannedScene:
    """`real`: number of real particles; `smallest`, `largest`, `sauter` mean diameter of them [m], `density` [kg/m3], of the whole; `smallest_cell`,
    `mean_cell`: width of cells, the cube root of their volume [m], and `depth`, the smallest extent of the vessel that does not repeat [m]; all three
    None without a gas, as `grain` and `velocity`, the superficial one [m/s]. `law`: name of the drag law, `drag` its function, None where drag_laws has none."""

    real: float
    smallest: float
    largest: float
    sauter: float
    density: float
    smallest_cell: Optional[float] = None
    mean_cell: Optional[float] = None
    depth: Optional[float] = None
    grain: Optional[Grain] = None
    velocity: Optional[float] = None
    law: str = ""

    @property
    def drag(self):
        return LAWS.get(LAWS_OF_MIXTURES.get(self.law, self.law))

    @property
    def minimum_fluidization(self):
        """U_mf [m/s] by the run's drag law, else by Wen and Yu; None without a gas, or where nothing has a weight."""
        if self.grain is None or self.grain.archimedes == 0:
            return None
        return self.grain.minimum_fluidization(self.drag) if self.drag else self.grain.minimum_fluidization_by_wen_yu

    def of_parcels(self, weight):
        """{name: number or None}: what evidence.NEAR compares, of parcels of `weight`."""
        parcel = self.sauter * weight ** (1 / 3)
        slowest = self.minimum_fluidization
        return {
            "velocity_over_minimum": self.velocity / slowest if slowest and self.velocity is not None else None,
            "archimedes": abs(self.grain.archimedes) if self.grain else None,
            "parcel_over_depth": parcel / self.depth if self.depth else None,
            "parcel_over_cell": parcel / self.mean_cell if self.mean_cell else None,
        }

    @property
    def relaxation_time(self):
        """m/k [s] in a bed of LOOSE_VOIDAGE at the superficial velocity, or that of U_mf where the gas is slower; None where drag is not known."""
        if self.drag is None or self.grain is None or not self.minimum_fluidization:
            return None
        slip = max(self.velocity or 0.0, self.minimum_fluidization) / LOOSE_VOIDAGE
        return self.grain.relaxation_time(self.drag, LOOSE_VOIDAGE, slip)


def of_run(run):
    """The `PlannedScene` of a Run whose first snapshot and, with a gas, mesh and last fields are there. InputError where there are no particles."""
    meta, first = run.meta, next((each for each in run.snapshots if len(each.ids)), None)
    if first is None:
        raise InputError(f"{run.path}: there are no particles so far: give the calibration more time (--calibrate), so that some are inserted")
    weight = first.read("weight").values if "weight" in first.names else float(meta["weight"])
    diameter, density = first.diameters / numpy.cbrt(weight), first.densities
    weights = numpy.broadcast_to(weight, diameter.shape)
    volume = weights * diameter**3
    facts = {
        "real": float(weights.sum()), "smallest": float(diameter.min()), "largest": float(diameter.max()),
        "sauter": float(volume.sum() / (weights * diameter**2).sum()), "density": float((volume * density).sum() / volume.sum()),
    }
    if "gas_volume" not in meta:
        return PlannedScene(**facts)
    meshes = [gas_mesh.read(each) for each in gas_mesh.pieces(run.path)]
    volumes = numpy.concatenate([mesh.volumes for mesh in meshes])
    domain = numpy.asarray(meta["domain"], dtype=float).reshape(2, 3)
    periodic = numpy.array(particle_source(Dictionaries(run.path), missing=[]).periodic)
    extents = (domain[1] - domain[0])[~periodic]
    grain = None
    if "gas_density" in meta and "gas_viscosity" in meta:
        grain = Grain(facts["sauter"], facts["density"], *(float(meta[name]) for name in ("gas_density", "gas_viscosity", "gravity")))
    return PlannedScene(**facts, smallest_cell=float(numpy.cbrt(volumes.min())), mean_cell=float(numpy.cbrt(volumes.mean())),
                        depth=float(extents.min()) if len(extents) else None, grain=grain, velocity=superficial_velocity(run, volumes),
                        law=str(meta["drag_law"]))  # fmt: skip


def superficial_velocity(run, volumes):
    """Flux of gas and solids together, of the vessel's mean cross-section [m/s], at the end of the run: the mean over all `volumes` [cells] of eps u and the
    solids' own. It is the inlet's flux in a vessel of one cross-section. None where the fields were not written."""
    try:
        voidage, velocity = (gas_fields.read(run.path, name) for name in ("voidage", "U"))
    except InputError:
        return None
    values = voidage.values[:, None] if voidage.values.ndim == 1 else voidage.values
    of_gas = (values * velocity.values * volumes[:, None]).sum(axis=0)
    last = run.snapshots[-1]
    of_solids = (numpy.pi / 6 * last.diameters[:, None] ** 3 * last.velocities).sum(axis=0) if len(last.ids) else 0.0
    return float(numpy.linalg.norm(of_gas + of_solids) / volumes.sum())
