"""The base of every paint of the database as a bare system ``M x = b``, for experiments on lobes and solvers.

The scripts ``compare_*.py`` share this: the paints, the angles that no fit has seen, and three ways to weigh lobes.
Nothing of the fitter is used here, so that what it does is compared and not repeated.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import load_any_paint
from brdf_suite.errors import UnreachableError
from brdf_suite.fitting.lobes.samples import BASE_GAMMAS_DEG, BASE_WEIGHTS
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.reflectance.designed.build import build_reflectance
from brdf_suite.reflectance.designed.layers import split_layers
from brdf_suite.reflectance.protocol import Layered
from brdf_suite.resources import resource, resource_names

#: ``(matrix (n, m), row weights (n,), targets (paints, n, channels)) -> columns (paints, m, channels)``
Solver = Callable[[Floats, Floats, Floats], Floats]

#: Designed paints, and the measured ones of facets (the VMV 2005 paper's Table 1).
FOLDERS = ("paints", "paints/cook_torrance")
ENDING = ".brdfpaint"
LIGHT_DEG = 45.0
COSINE = float(np.cos(np.radians(LIGHT_DEG)))
#: Where paints are measured, and angles of which no set of samples in these scripts holds one.
MEASURED = (15.0, 45.0, 110.0)
HELD_OUT = (5.0, 11.0, 18.0, 28.0, 32.0, 40.0, 52.0, 57.0, 66.0, 72.0, 82.0, 88.0, 95.0, 103.0)


def paints(rule: str | None = None, count: int | None = None) -> dict[str, Layered]:
    """Return base and coat of the shipped paints by their files' names; ``rule`` replaces their interpolation.

    Paints of facets have no such rule and are the same under each; a paint that cannot be built by the rule is
    left out. ``count`` paints at most, spread over the database.
    """
    files = {name: (folder, name) for folder in FOLDERS for name in resource_names(folder, ENDING)}
    names = list(files)
    if count is not None:
        names = names[:: max(1, len(names) // count)][:count]
    found = {}
    for name in names:
        folder, stem = files[name]
        paint = load_any_paint(resource(folder, stem + ENDING))
        if rule is not None and isinstance(paint, Paint):
            paint = replace(paint, interpolation=rule)
        try:
            layers = split_layers(build_reflectance(paint))
        except UnreachableError as error:
            print(f"{name} by the {rule} rule is left out: {error}")
            continue
        if layers is not None:
            found[name] = layers
    return found


def base_values(layers: Sequence[Layered], gammas_deg: Sequence[float]) -> Floats:
    """Return ``f_r·(N·L)`` of the bases at aspecular angles, light at 45°: ``(paints, n, 3)``."""
    views = aspecular_view(LIGHT_DEG, np.asarray(gammas_deg, np.float64))
    return np.stack([COSINE * item.base.eval(illumination(LIGHT_DEG), views) for item in layers])


@dataclass(frozen=True)
class Lobes:
    """A set of lobes: ``cosine`` exponents of ``(R·V)^E``, ``half`` ones of ``((1 + R·V)/2)^E``."""

    cosine: tuple[float, ...]
    half: tuple[float, ...] = ()

    @property
    def count(self) -> int:
        """Number of lobes, KD not counted."""
        return len(self.cosine) + len(self.half)

    def of_cosine(self, cosine: Floats) -> Floats:
        """Return the lobes ``(..., m)`` at ``R·V`` (...)."""
        lit = np.clip(cosine, 0.0, None)[..., None]
        values: Floats = np.concatenate(
            [lit ** np.array(self.cosine), (0.5 + 0.5 * cosine[..., None]) ** np.array(self.half)], axis=-1
        )
        return values

    def matrix(self, gammas_deg: Sequence[float]) -> Floats:
        """Return the columns KD, KDD_1 … at aspecular angles, light at 45°: ``(n, 1 + m)``."""
        cosine = np.cos(np.radians(np.asarray(gammas_deg, np.float64)))
        return COSINE * np.concatenate([np.ones((cosine.size, 1)), self.of_cosine(cosine)], axis=1)


def l1_program(matrix: Floats, weights: Floats, targets: Floats) -> Floats:
    """Minimize ``Σ w |M x - b|``, x ≥ 0: all paints and channels as one block-diagonal program."""
    from scipy import sparse
    from scipy.optimize import linprog

    scale = weights @ matrix
    scale = np.where(scale > 0.0, scale, 1.0)
    blocks, sizes = _columns(weights, targets)
    system = sparse.csr_matrix(weights[:, None] * matrix / scale)
    count, (rows, unknowns) = blocks.shape[0], system.shape
    one = sparse.identity(count * rows, format="csr")
    answer = linprog(
        np.concatenate([np.zeros(count * unknowns), np.ones(2 * count * rows)]),
        A_eq=sparse.hstack([sparse.kron(sparse.identity(count), system), one, -one], format="csr"),
        b_eq=1e3 * blocks.ravel(),  # the solver's tolerance is absolute
        bounds=(0.0, None),
        method="highs-ds",
    )
    if answer.status != 0:
        raise RuntimeError(answer.message)
    solution = 1e-3 * answer.x[: count * unknowns].reshape(count, unknowns) / scale * sizes[:, None]
    return _by_paint(np.maximum(solution, 0.0), targets)


def non_negative_least_squares(matrix: Floats, weights: Floats, targets: Floats) -> Floats:
    """Minimize ``Σ w (M x - b)²``, x ≥ 0 (Lawson and Hanson), channel by channel."""
    from scipy.optimize import nnls

    root = np.sqrt(weights)
    scale = np.linalg.norm(root[:, None] * matrix, axis=0)
    scale = np.where(scale > 0.0, scale, 1.0)
    blocks, sizes = _columns(root, targets)
    solution = [nnls(root[:, None] * matrix / scale, b, maxiter=5_000)[0] for b in blocks]
    return _by_paint(np.array(solution) / scale * sizes[:, None], targets)


def clamped_least_squares(matrix: Floats, weights: Floats, targets: Floats) -> Floats:
    """Minimize ``Σ w (M x - b)²`` with x of any sign, then set what is negative to 0."""
    root = np.sqrt(weights)
    scale = np.linalg.norm(root[:, None] * matrix, axis=0)
    scale = np.where(scale > 0.0, scale, 1.0)
    blocks, sizes = _columns(root, targets)
    solution = np.linalg.lstsq(root[:, None] * matrix / scale, blocks.T, rcond=1e-12)[0].T
    return _by_paint(np.maximum(solution / scale * sizes[:, None], 0.0), targets)


def _columns(factors: Floats, targets: Floats) -> tuple[Floats, Floats]:
    """Weighted targets, one row per paint and channel, scaled to a sum of 1; and what they were scaled by."""
    blocks = np.moveaxis(factors[:, None] * targets, 1, 2).reshape(-1, targets.shape[1])
    sizes = np.abs(blocks).sum(axis=1)
    sizes = np.where(sizes > 0.0, sizes, 1.0)
    return blocks / sizes[:, None], sizes


def _by_paint(solution: Floats, targets: Floats) -> Floats:
    return np.moveaxis(solution.reshape(targets.shape[0], targets.shape[2], -1), 1, 2)


@dataclass(frozen=True)
class Fitted:
    """ΔE00 between bases and their fits: ``measured`` (paints, 3) and ``held_out`` (paints, n)."""

    measured: Floats
    held_out: Floats

    @property
    def rms(self) -> Floats:
        """RMS over the held-out angles (paints,): Error(E, B_i) of the paper's equation 4."""
        return np.asarray(np.sqrt((self.held_out**2).mean(axis=1)))

    @property
    def equation_4(self) -> float:
        """Largest plus mean error over the paints."""
        return float(self.rms.max() + self.rms.mean())


@dataclass(frozen=True)
class Database:
    """Targets of a fit and the colours that it is judged by, for all paints under one rule."""

    layers: tuple[Layered, ...]
    gammas_deg: tuple[float, ...]
    weights: Floats
    targets: Floats
    measured: Floats
    held_out: Floats

    @classmethod
    def of(
        cls,
        layers: Sequence[Layered],
        gammas_deg: Sequence[float] = BASE_GAMMAS_DEG,
        weights: Sequence[float] = BASE_WEIGHTS,
    ) -> Database:
        """Sample ``layers`` at the angles of a fit (the fitter's own if left out)."""
        return cls(
            tuple(layers),
            tuple(gammas_deg),
            np.array(weights, np.float64),
            base_values(layers, gammas_deg),
            _colours(base_values(layers, MEASURED)),
            _colours(base_values(layers, HELD_OUT)),
        )

    def fit(self, lobes: Lobes, solver: Solver = l1_program) -> Floats:
        """Return KD, KDD_1 … ``(paints, 1 + m, 3)``."""
        return solver(lobes.matrix(self.gammas_deg), self.weights, self.targets)

    def errors(self, lobes: Lobes, solver: Solver = l1_program) -> Fitted:
        """Fit and compare."""
        return self.errors_of(lobes, self.fit(lobes, solver))

    def errors_of(self, lobes: Lobes, columns: Floats) -> Fitted:
        """Compare with columns ``(paints, 1 + m, 3)``."""

        def differences(gammas_deg: Sequence[float], wanted: Floats) -> Floats:
            return delta_e_2000(wanted, _colours(lobes.matrix(gammas_deg) @ columns))

        return Fitted(differences(MEASURED, self.measured), differences(HELD_OUT, self.held_out))


def _colours(reflected: Floats) -> Floats:
    return working_to_lab(np.pi / COSINE * reflected)


def table(header: Sequence[str], rows: Sequence[Sequence[str]], title: str = "") -> None:
    """Print a table in Markdown."""
    print(f"\n{title}\n" if title else "")
    print("| " + " | ".join(header) + " |\n|" + "---|" * len(header))
    for row in rows:
        print("| " + " | ".join(row) + " |")


def arguments(description: str) -> argparse.Namespace:
    """Parse ``--paints N``: use N paints only, to see whether the script runs."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--paints", type=int, default=None, help="use so many paints of the database only")
    return parser.parse_args()
