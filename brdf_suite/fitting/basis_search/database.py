"""Sampled paints of a basis search: the fit's targets and the validation data.

The targets of the error are at places that the fit does not see:

- **Colour**: L*a*b*, light at 45°, at the aspecular angles :data:`BETWEEN_DEG`: those between the base's samples, and
  the measured ones, at which no sample of the fit sees base and coat together. From :data:`COAT_FROM_DEG` on it is that
  of the whole paint: at the measured angles as an instrument sees it, in the plane of incidence; between them with
  the coat's mean around the mirror direction, which is all that round lobes can follow. Nearer the coat outshines the
  base, so there it is the base alone.
A paint of readings represents what a stylist makes of it, too: beside it there is one edit of it, the reading at 45°
moved towards that at 15° (:data:`EDITS`), as a drag in Designer does. Lobes chosen for the paints alone missed such
edits by up to 7 ΔE00 at the very angle that was moved.

- **Coat**: the share of the coat's energy within a radius of the mirror direction of a view at 45°, at
  :data:`RADII` radii evenly spaced in log from .1° to 30°, integrated on rings far finer than the fit's. What is
  within .9° is what a 20° glossmeter takes in; what is beyond is haze.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import documents_in
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import PAINT_ENDING, AnyPaint, load_any_paint
from brdf_suite.errors import FileError, FittingError, SuiteError, UnreachableError
from brdf_suite.fitting.lobes.samples import BaseSamples, CoatSamples
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.reflectance.designed.build import build_reflectance
from brdf_suite.reflectance.designed.layers import split_layers
from brdf_suite.reflectance.protocol import Layered
from brdf_suite.regular_files import read_bytes

#: Aspecular angles at which colours are compared, degrees. Beyond 90° only KD is left of a fit.
BETWEEN_DEG = (
    *(3.0, 5.5, 10.5, 12.5, 15.0, 17.5, 22.5, 27.5, 30.0, 32.5, 37.5, 40.0),
    *(42.5, 45.0, 47.5, 50.0, 55.0, 65.0, 70.0, 80.0, 85.0, 100.0, 105.0),
)
MEASURED_DEG = (15.0, 45.0, 110.0)
COAT_FROM_DEG = 10.0
LIGHT_DEG = 45.0
#: L* at 45° of an edit, as a share of the way from the reading at 110° to that at 15°; the paints take them in turn.
EDITS = (0.35, 0.5, 0.65)
#: An edited L* is at least so far from the paint's own: nearer it would be the same paint twice.
LEAST_EDIT = 5.0
#: Azimuths of half a ring around the mirror direction, for the coat's mean.
AZIMUTHS = 12
#: Number of radii at which the coat's energy is compared, and their ends in degrees.
RADII = 24
RADII_DEG = (0.1, 30.0)
#: The rings of the coat's integral: step in log angle and first ring in radians.
FINE_STEP = 0.05
FINE_FIRST_RAD = 2e-4


@dataclass(frozen=True, eq=False)
class PaintTargets:
    """Targets of one paint: samples for the fit, and validation data.

    ``base`` (n, 3) and ``coat`` (k, 3): ``f_r·(N·L)`` at the fit's samples, 1/sr, linear Rec. 2020; ``lab``
    (angles, 3) at :data:`BETWEEN_DEG`; ``inside`` (radii, 3): energy of the coat within each radius,
    over the mean of its channels' whole energies, with ``energy`` that mean (0 and zeros where there is no coat).
    """

    name: str
    base: Floats
    coat: Floats
    lab: Floats
    inside: Floats
    energy: float


def coat_rings() -> tuple[CoatSamples, NDArray[np.intp]]:
    """Return the fine rings of the coat's energy, and the index of the ring at each of the radii."""
    fine = CoatSamples(first_ring_rad=FINE_FIRST_RAD, log_step=FINE_STEP, azimuths=12)
    radii = np.radians(np.geomspace(*RADII_DEG, RADII))
    return fine, np.asarray(np.searchsorted(fine.gamma_rad, radii))


def sample_targets(name: str, paint: Layered) -> PaintTargets:
    """Sample a paint of two layers; errors of its evaluation pass."""
    base_samples, coat_samples = BaseSamples(), CoatSamples()
    fine, at = coat_rings()

    def rings(samples: CoatSamples) -> Floats:
        values = paint.coat.eval(samples.lights, samples.view) * samples.cosines[..., None]
        return np.asarray(values.mean(axis=1))

    light = base_samples.light
    base = np.cos(base_samples.theta_rad) * paint.base.eval(light, base_samples.views)
    between = paint.base.eval(illumination(LIGHT_DEG), aspecular_view(LIGHT_DEG, np.array(BETWEEN_DEG)))
    between = between + _coat_between(paint)
    within = np.cumsum(fine.solid_angle[:, None] * rings(fine), axis=0)
    energy = float(within[-1].mean())
    scale = 1.0 / energy if energy > 0.0 else 0.0
    targets = PaintTargets(
        name, base, rings(coat_samples), working_to_lab(np.pi * between), within[at] * scale, energy
    )
    for part in (targets.base, targets.coat):
        if not (np.isfinite(part).all() and (part >= 0.0).all()):
            raise FittingError(f"{name}: the reflectance is negative or not finite at a sample of the fit.")
    return targets


def coat_counts() -> Floats:
    """Return ``(angles,)``: 1 at the angles at which the coat is part of the colour, 0 nearer to the mirror."""
    return (np.array(BETWEEN_DEG) >= COAT_FROM_DEG).astype(np.float64)


def _coat_between(paint: Layered) -> Floats:
    """f_r (angles, 3) of the coat, in the plane at the measured angles, else the mean over a ring.

    The ring's mean is of ``f_r·(N·L)``, over the cosine of the colours' light.
    """
    light = np.radians(LIGHT_DEG)
    mirror = np.array([np.sin(light), 0.0, np.cos(light)])
    inwards = np.array([-np.cos(light), 0.0, np.sin(light)])
    azimuth = (np.arange(AZIMUTHS) + 0.5) * np.pi / AZIMUTHS
    around = np.cos(azimuth)[:, None] * inwards + np.sin(azimuth)[:, None] * np.array([0.0, 1.0, 0.0])
    gamma = np.radians(BETWEEN_DEG)[:, None, None]
    lights = np.cos(gamma) * mirror + np.sin(gamma) * around
    values = paint.coat.eval(lights, illumination(LIGHT_DEG)) * np.clip(lights[..., 2:], 0.0, None)
    plane = paint.coat.eval(illumination(LIGHT_DEG), aspecular_view(LIGHT_DEG, np.array(BETWEEN_DEG)))
    measured = np.isin(BETWEEN_DEG, MEASURED_DEG)[:, None]
    seen = np.where(measured, plane, values.mean(axis=1) / np.cos(light))
    return np.asarray(coat_counts()[:, None] * seen)


@dataclass(frozen=True, eq=False)
class Database:
    """Paints of a search and ``sha256``, the hash of their files (names and contents)."""

    paints: tuple[PaintTargets, ...]
    sha256: str

    @property
    def names(self) -> tuple[str, ...]:
        """The paints' names, in the order of all per-paint arrays."""
        return tuple(paint.name for paint in self.paints)


def load_database(folder: Path) -> Database:
    """Read every ``.brdfpaint`` in ``folder`` and the folders below it, in the order of their names, and edit them.

    Raises
    ------
    FileError, DocumentError
        There is no paint, or one cannot be read.
    SuiteError
        A paint has no reflectance, or one that cannot be fitted; the message names the file.
    """
    files = _paint_files(folder)
    digest = _hash_of(folder, files)
    paints: dict[str, PaintTargets] = {}
    for number, path in enumerate(files):
        name = path.name.removesuffix(PAINT_ENDING)
        if name in paints:
            raise FileError(path, "another paint of the database has the same file name")
        try:
            paint = load_any_paint(path)
            layers = split_layers(build_reflectance(paint))
        except FileError:
            raise
        except SuiteError as error:
            raise FileError(path, f"cannot be part of the database: {error}") from error
        if layers is None:
            raise FileError(path, "cannot be part of the database: nothing divides it into coat and base")
        paints[name] = sample_targets(name, layers)
        edit = _edited(paint, EDITS[number % len(EDITS)])
        if edit is not None:
            paints[f"{name}, edited"] = sample_targets(f"{name}, edited", edit)
    return Database(tuple(paints.values()), digest)


def database_sha256(folder: Path) -> str:
    """Return the hash that :func:`load_database` would give its database: whether a stored search is of these paints.

    Raises :class:`FileError` where there is no paint; a paint that cannot be fitted is not noticed.
    """
    return _hash_of(folder, _paint_files(folder))


def _paint_files(folder: Path) -> list[Path]:
    found = documents_in(folder, PAINT_ENDING, within=True)
    files = sorted(found, key=lambda path: path.relative_to(folder).as_posix())
    if not files:
        raise FileError(folder, f"there is no paint ({PAINT_ENDING}) in this folder")
    return files


def _hash_of(folder: Path, files: list[Path]) -> str:
    digest = hashlib.sha256(repr(("edits", EDITS, LEAST_EDIT)).encode())
    for path in files:
        digest.update(os.fsencode(path.relative_to(folder).as_posix()) + b"\0")
        digest.update(hashlib.sha256(_content(path)).digest())
    return digest.hexdigest()


def _content(path: Path) -> bytes:
    """Return what a paint's file says of its mean: without flakes and targets of texture, and without the version."""
    raw = read_bytes(path)
    try:
        record = json.loads(raw)
    except ValueError:  # reported when it is read; here it only differs from what was searched
        return raw
    if not isinstance(record, dict):
        return raw
    for name in ("version", "flakes", "texture"):
        record.pop(name, None)
    return json.dumps(record, sort_keys=True).encode()


def _edited(paint: AnyPaint, share: float) -> Layered | None:
    """Return the paint with its reading at 45° moved, or None where it has none, hardly moves, or cannot be."""
    if not isinstance(paint, Paint) or len(paint.measurements) != len(MEASURED_DEG):
        return None
    if {m.aspecular_deg for m in paint.measurements} != set(MEASURED_DEG):
        return None
    bright, middle, dark = (paint.lab_at(angle) for angle in MEASURED_DEG)
    lightness = dark[0] + share * (bright[0] - dark[0])
    if abs(lightness - middle[0]) < LEAST_EDIT:
        return None
    try:
        return split_layers(build_reflectance(paint.with_lab(MEASURED_DEG[1], (lightness, *middle[1:]))))
    except UnreachableError:  # the edit is one that Designer refuses
        return None


def reflectances(paints: Mapping[str, Layered]) -> Database:
    """Return a database of reflectances that come from no file; its hash is that of the samples."""
    targets = tuple(sample_targets(name, paint) for name, paint in paints.items())
    digest = hashlib.sha256()
    for paint in targets:
        digest.update(paint.name.encode() + b"\0" + paint.base.tobytes() + paint.coat.tobytes())
    return Database(targets, digest.hexdigest())
