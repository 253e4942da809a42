"""Error(E, paint) of the paper's equation 4: the residual of the lobes E for each paint of a database.

The weights are those that the product finds: the linear program of :class:`LobeFitter`, KD and KDD to the base, KG
to the coat. Each paint's error is the RMS of residuals of two kinds, half and half:

- ΔE00 between paint and fit at the aspecular angles of :data:`~.database.BETWEEN_DEG`, in units of 1, at the measured
  ones in units of :data:`MEASURED_UNIT`;
- the difference of the coat's energy within a radius (:func:`~.database.coat_rings`), mean over channels, in units of
  :data:`ENERGY_UNIT` of the coat's energy.

Both units are about what an observer just sees: a ΔE00 of 1, and, as what lies within .9° is what a 20° glossmeter
takes in, some four of 90 gloss units. So no paint counts more for being light, and neither layer drowns the other.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError
from brdf_suite.fitting.basis_search.database import (
    BETWEEN_DEG,
    LIGHT_DEG,
    MEASURED_DEG,
    Database,
    coat_counts,
    coat_rings,
)
from brdf_suite.fitting.lobes.highs_model import BlockSolver, SolverOutcome
from brdf_suite.fitting.lobes.program import PartProgram, base_program, coat_program, with_energy
from brdf_suite.fitting.lobes.samples import BaseSamples, CoatSamples

#: What counts as much at the measured angles as a ΔE00 of 1 elsewhere: there readings are compared with the paint.
MEASURED_UNIT = 0.4
#: The share of a coat's energy that counts as much as a ΔE00 of 1.
ENERGY_UNIT = 0.05
#: What the numbers of a stored search are; part of the file.
MEANING = (
    "Error(E, paint) of the paper's equation 4: the root mean square of two kinds of residual, half and half, of the "
    "fit that the product makes. Colour: ΔE00 between paint and fit at aspecular angles that the fit does not see, at "
    f"the measured angles in units of {MEASURED_UNIT:g}, else of 1. Coat: the share of its energy within a radius of "
    f"the mirror direction, in units of {ENERGY_UNIT:g}. Both units are about what an observer just sees."
)
#: Far beyond what a fit takes: the answer must not depend on how busy the machine is.
PATIENCE_S = 60.0
#: Channels that one model of the solver holds for base and coat: enough to save calls, few enough to stay fast.
BASE_BATCH, COAT_BATCH = 6, 1


class BasisError:
    """The errors of a basis over a database, as a deterministic function of its exponents."""

    def __init__(self, database: Database) -> None:
        self.database = database
        self._base_samples, self._coat_samples = BaseSamples(), CoatSamples()
        self._fine, self._at = coat_rings()
        self._cos_between = np.clip(np.cos(np.radians(BETWEEN_DEG)), 0.0, None)[:, None]
        units = np.where(np.isin(BETWEEN_DEG, MEASURED_DEG), MEASURED_UNIT, 1.0)
        self._colour_weights = units**-2 / (units**-2).sum()
        self._gloss_counts = coat_counts()[:, None] / np.cos(np.radians(LIGHT_DEG))
        self._base = np.concatenate([paint.base for paint in database.paints], axis=1)
        coats = [with_energy(self._coat_samples, paint.coat) for paint in database.paints]
        # A coat without colour is fitted once; where[i] says which column a paint's channel is.
        grey = [bool((coat == coat[:, :1]).all()) for coat in coats]
        columns = [coat[:, :1] if same else coat for coat, same in zip(coats, grey, strict=True)]
        starts = np.cumsum([0] + [c.shape[1] for c in columns[:-1]])
        self._coat = np.concatenate(columns, axis=1)
        self._where = np.array(
            [s + (0 if g else np.arange(3)) + np.zeros(3, int) for s, g in zip(starts, grey, strict=True)]
        )
        self._lab = np.stack([paint.lab for paint in database.paints])
        self._inside = np.stack([paint.inside for paint in database.paints])
        energy = np.array([paint.energy for paint in database.paints])
        self._scale = np.where(energy > 0.0, 1.0 / np.where(energy > 0.0, energy, 1.0), 0.0)

    def programs(self, exponents: Floats) -> tuple[PartProgram, PartProgram]:
        """Return the programs of base and coat, those of a :class:`LobeFitter` with these exponents."""
        base = base_program(self._base_samples, exponents)
        return base, coat_program(self._coat_samples, exponents)

    def layers(self, exponents: Sequence[float] | Floats) -> tuple[Floats, Floats]:
        """Return RMS errors ``(paints,)`` of colour and of the coat's energy, each in its unit.

        Raises
        ------
        FittingError
            An exponent that is not finite or below 1, or a program without an optimum.
        """
        lobes = np.sort(np.asarray(exponents, dtype=np.float64))
        if lobes.ndim != 1 or lobes.size == 0 or not (np.isfinite(lobes).all() and lobes[0] >= 1.0):
            raise FittingError(f"Lobe exponents must be finite and at least 1, not {lobes}.")
        programs = self.programs(lobes)
        base = _solve(programs[0], self._base, BASE_BATCH).reshape(lobes.size + 1, -1, 3)
        coat = _solve(programs[1], self._coat, COAT_BATCH)[:, self._where]
        between = self._cos_between**lobes
        brdf = base[0] + np.einsum("am,mpc->apc", between, base[1:])
        brdf += np.einsum("am,mpc->apc", self._gloss_counts * between, coat)
        lab = working_to_lab(np.pi * np.swapaxes(brdf, 0, 1))
        colour = delta_e_2000(self._lab, lab)
        reach = np.cumsum(self._fine.solid_angle[:, None] * self._fine.cosine_lobes(lobes), axis=0)[self._at]
        energy = np.einsum("rm,mpc->prc", reach, coat) * self._scale[:, None, None]
        moved = (energy - self._inside) / ENERGY_UNIT
        return np.sqrt(colour**2 @ self._colour_weights), np.sqrt((moved**2).mean(axis=(1, 2)))

    def __call__(self, exponents: Sequence[float] | Floats) -> Floats:
        """Return Error(E, paint) ``(paints,)`` for exponents ``(m,)`` in any order; raises as :meth:`layers`."""
        base, coat = self.layers(exponents)
        return np.asarray(np.sqrt(0.5 * (base**2 + coat**2)))


def equation_4(errors: Floats) -> float:
    """Return the paper's equation 4 for errors ``(paints,)``: their maximum plus their mean."""
    return float(errors.max() + errors.mean())


def _solve(program: PartProgram, targets: Floats, batch: int) -> Floats:
    """Return the optimal columns ``(m, k)`` for unweighted ``targets`` ``(n, k)``."""
    weighted = program.row_weights[:, None] * targets
    sizes = np.abs(weighted).sum(axis=0)
    scaled = weighted / np.where(sizes > 0.0, sizes, 1.0)
    # A new model each time: the optimum of a degenerate program must depend on nothing that was solved before.
    solver = BlockSolver((program,), batch)
    parts = []
    for start in range(0, targets.shape[1], batch):
        chunk = scaled[:, start : start + batch]
        used = chunk.shape[1]
        if used < batch:
            chunk = np.concatenate([chunk, np.zeros((chunk.shape[0], batch - used))], axis=1)
        solver.load([chunk])
        if solver.run(PATIENCE_S) is not SolverOutcome.OPTIMAL:
            solver.forget()
            if solver.run(PATIENCE_S) is not SolverOutcome.OPTIMAL:
                raise FittingError("The linear program of a basis was not solved; the basis is left out.")
        parts.append(solver.solution().solutions[0][:, :used])
    return np.asarray(np.concatenate(parts, axis=1) * program.column_scale[:, None] * sizes)
