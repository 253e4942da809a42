"""A standard, and batches judged against it: differences per angle, pass or fail, and the trade's words.

A standard is what a batch shall look like: readings at some geometries and, where there is more than readings (a
paint, a measured file), a reflectance from which the virtual spectrophotometer reads any other geometry.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import cached_property

import numpy as np

from brdf_suite.appearance.colour.flat_colours import within_paint
from brdf_suite.appearance.difference.formulas import weights_2000
from brdf_suite.appearance.difference.tolerance import (
    DIFFERENCES,
    AngleVerdict,
    Tolerances,
    Verdict,
    find_difference,
    judge,
)
from brdf_suite.appearance.difference.words import (
    NamedDifference,
    Say,
    in_english,
    name_differences,
    name_flop,
    sentence,
)
from brdf_suite.appearance.flop.travel import flop_index
from brdf_suite.appearance.geometries import Geometry, GeometrySet
from brdf_suite.documents.paint import Gloss, Lab, Measurement, Paint
from brdf_suite.errors import SuiteError
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.instruments.spectrophotometer import SUPPORT_DEG, Reading, measure
from brdf_suite.reflectance.protocol import Reflectance

SAME_DEG = 1e-6
FLOP_DEG = (15.0, 45.0, 110.0)
FLOP_LIGHT_DEG = 45.0


@dataclass(frozen=True, eq=False)
class Standard:
    """What batches are compared with.

    ``name`` is what it is called, ``origin`` where it is from (a file, a palette and its place in it), for the user.
    ``readings`` are its own, D65 and 10°; ``gloss`` in gloss units where it is known. ``paint`` is the designed paint
    that it was read of, where there is one; ``reflectance`` that of anything else.
    """

    name: str
    origin: str
    readings: tuple[Measurement, ...]
    gloss: Gloss | None = None
    paint: Paint | None = None
    reflectance: Reflectance | None = None
    notices: tuple[str, ...] = ()
    _computed: dict[tuple[float, float], Reading] = field(default_factory=dict, repr=False)

    def lab_at(self, illumination_deg: float, aspecular_deg: float) -> tuple[Lab, bool] | None:
        """Return L*a*b* at a geometry, degrees, and whether it was computed instead of read.

        ``None`` where it has no reading there, and nothing that one could be computed from.
        """
        for reading in self.readings:
            if _is_at(reading, illumination_deg, aspecular_deg):
                return reading.lab, False
        key = (illumination_deg, aspecular_deg)
        if key not in self._computed:
            reflectance = self.seen
            if reflectance is None:
                return None
            report = measure(reflectance, GeometrySet("one", "one", (Geometry(*key),)))
            self._computed[key] = report.readings[0]
        return self._computed[key].lab, True

    def sample_deg_at(self, illumination_deg: float, aspecular_deg: float) -> float:
        """Return the angle from a computed colour of :meth:`lab_at` to its nearest sample, degrees.

        0 where the colour was read, or its reflectance is known everywhere.
        """
        found = self._computed.get((illumination_deg, aspecular_deg))
        return 0.0 if found is None else found.sample_deg

    def computed(self) -> dict[tuple[float, float], Lab]:
        """Return what was read of its reflectance so far, by illumination and aspecular angle, degrees."""
        return {place: reading.lab for place, reading in self._computed.items()}

    @cached_property
    def seen(self) -> Reflectance | None:
        """Its reflectance; of a paint it is built at the first call. ``None`` where there is none.

        A paint that cannot be built (its gloss is out of reach, say) has its readings only.
        """
        if self.reflectance is not None or self.paint is None:
            return self.reflectance
        try:
            return build_paint(self.paint)
        except (
            SuiteError
        ):  # its readings are judged all the same; the notice of the paint itself is the desk's
            return None


def standard_of(paint: Paint, origin: str = "") -> Standard:
    """Return a designed paint as a standard."""
    return Standard(paint.name, origin, paint.measurements, paint.gloss, paint)


@dataclass(frozen=True)
class AngleRow:
    """One geometry of a batch against the standard; ``standard`` is ``None`` where that has no colour there.

    ``computed``: the standard's colour is from its reflectance and was not read. ``differences`` by name of the
    formula. ``words`` are empty where no difference is to be seen. ``sample_deg`` is the angle from the standard's
    computed colour to its nearest sample, degrees.
    """

    illumination_deg: float
    aspecular_deg: float
    batch: Lab
    standard: Lab | None
    computed: bool
    differences: Mapping[str, float]
    verdict: AngleVerdict | None
    words: tuple[NamedDifference, ...]
    sample_deg: float = 0.0

    @property
    def supported(self) -> bool:
        """Whether the standard has a sample near enough, where its colour is computed from samples."""
        return self.sample_deg <= SUPPORT_DEG

    @property
    def marks(self) -> str:
        """The signs behind the angle: ``*`` for a computed standard, ``†`` without a sample near it."""
        return ("*" if self.computed else "") + ("" if self.supported else "†")

    @property
    def angle(self) -> str:
        """What the angle is called: its aspecular angle, with its light where that is not at 45°."""
        return Geometry(self.illumination_deg, self.aspecular_deg).label


@dataclass(frozen=True)
class BatchReport:
    """A batch against a standard, row by row in the batch's own order.

    ``flop`` is the standard's flop index and the batch's, where both are read at 15, 45 and 110°; ``gloss`` is batch
    minus standard in gloss units, by angle, where both know it.
    """

    name: str
    rows: tuple[AngleRow, ...]
    difference: str
    flop: tuple[float, float] | None
    flop_word: NamedDifference | None
    gloss: Mapping[int, float]

    @property
    def passes(self) -> bool | None:
        """True where every judged angle passes, ``None`` where none is judged."""
        return self.verdict.passes

    @property
    def verdict(self) -> Verdict:
        """The rows that have a standard, as a verdict."""
        return Verdict(tuple(row.verdict for row in self.rows if row.verdict is not None), self.difference)

    @property
    def largest(self) -> float | None:
        """The largest difference by the chosen formula; ``None`` where no angle can be compared."""
        return max((row.verdict.difference for row in self.rows if row.verdict is not None), default=None)

    @property
    def mean(self) -> float | None:
        """The mean difference by the chosen formula over all angles that can be compared."""
        values = [row.verdict.difference for row in self.rows if row.verdict is not None]
        return sum(values) / len(values) if values else None

    def sentence(self, say: Say = in_english) -> str:
        """Return the whole in words: ``darker and bluer at 110°; more flop``."""
        rows = [row for row in self.rows if row.verdict is not None]
        return sentence([row.angle for row in rows], [row.words for row in rows], self.flop_word, say)

    def to_json(self) -> dict[str, object]:
        """Return it as plain values; angles in degrees."""
        return {
            "name": self.name,
            "difference": self.difference,
            "passes": self.passes,
            "words": self.sentence(),
            "flop_index": None if self.flop is None else {"standard": self.flop[0], "batch": self.flop[1]},
            "gloss_difference": {f"gu_{angle}": value for angle, value in self.gloss.items()},
            "angles": [
                {
                    "illumination_deg": row.illumination_deg,
                    "aspecular_deg": row.aspecular_deg,
                    "lab": list(row.batch),
                    "lab_standard": None if row.standard is None else list(row.standard),
                    "standard_computed": row.computed,
                    "standard_nearest_sample_deg": row.sample_deg,
                    **{f"delta_e_{name}": value for name, value in row.differences.items()},
                    "verdict": None if row.verdict is None else asdict(row.verdict),
                    "words": [one.text() for one in row.words],
                }
                for row in self.rows
            ],
        }


def judge_batch(
    standard: Standard, batch: Paint, tolerances: Tolerances, differences: Sequence[str] = ()
) -> BatchReport:
    """Return how a batch differs from the standard at each of the batch's readings.

    ``differences`` names formulas to work out beside that of the tolerances. The batch's values are its readings, what
    the paint shall look like, and not what a fit makes of them.

    >>> from brdf_suite.documents.paint import solid_paint
    >>> grey = solid_paint("grey", (50.0, 0.0, 0.0))
    >>> report = judge_batch(standard_of(grey), solid_paint("darker", (48.0, 0.0, 0.0)), Tolerances({}, 1.0))
    >>> report.passes, report.sentence()
    (False, 'darker at every angle')
    """
    found = [standard.lab_at(m.illumination_deg, m.aspecular_deg) for m in batch.measurements]
    places = [index for index, one in enumerate(found) if one is not None]
    verdicts: dict[int, AngleVerdict] = {}
    values: dict[str, dict[int, float]] = {}
    words: dict[int, tuple[NamedDifference, ...]] = {}
    if places:
        references = np.array([one[0] for one in found if one is not None])
        samples = np.array([batch.measurements[index].lab for index in places])
        angles = [batch.measurements[index].aspecular_deg for index in places]
        verdict = judge(angles, references, samples, tolerances)
        verdicts = dict(zip(places, verdict.angles, strict=True))
        weights = weights_2000(references, samples).tolist()
        for row, index in enumerate(places):
            words[index] = name_differences(references[row], samples[row], weights[row])
        for name in dict.fromkeys((tolerances.difference, *differences)):
            of_all = (
                [judged.difference for judged in verdict.angles]
                if name == tolerances.difference
                else find_difference(name)(references, samples).tolist()
            )
            values[name] = dict(zip(places, of_all, strict=True))
    rows = []
    for index, (measurement, one) in enumerate(zip(batch.measurements, found, strict=True)):
        rows.append(
            AngleRow(
                measurement.illumination_deg,
                measurement.aspecular_deg,
                measurement.lab,
                None if one is None else one[0],
                one is not None and one[1],
                {name: of[index] for name, of in values.items() if index in of},
                verdicts.get(index),
                words.get(index, ()),
                standard.sample_deg_at(measurement.illumination_deg, measurement.aspecular_deg),
            )
        )
    flop = _flops(standard, batch)
    word = None if flop is None else name_flop(*flop)
    return BatchReport(
        batch.name, tuple(rows), tolerances.difference, flop, word, _gloss(standard.gloss, batch.gloss)
    )


def judge_all(standard: Standard, batches: Sequence[Paint], tolerances: Tolerances) -> list[BatchReport]:
    """Return every batch against the one standard, with all the usual formulas, in the order given."""
    return [judge_batch(standard, batch, tolerances, tuple(DIFFERENCES)) for batch in batches]


def _flops(standard: Standard, batch: Paint) -> tuple[float, float] | None:
    lightness: list[tuple[float, float]] = []
    for angle in FLOP_DEG:
        read = [m.lab[0] for m in batch.measurements if _is_at(m, FLOP_LIGHT_DEG, angle)]
        known = standard.lab_at(FLOP_LIGHT_DEG, angle) if read else None
        if known is None:
            return None
        lightness.append((known[0][0], read[0]))
    values = flop_index(*(pair[0] for pair in lightness)).value, flop_index(*(p[1] for p in lightness)).value
    return values if all(map(math.isfinite, values)) else None


def _gloss(standard: Gloss | None, batch: Gloss) -> dict[int, float]:
    if standard is None:
        return {}
    found = {20: batch.gu_20 - standard.gu_20}
    if batch.gu_60 is not None and standard.gu_60 is not None:
        found[60] = batch.gu_60 - standard.gu_60
    return found


def _is_at(measurement: Measurement, illumination_deg: float, aspecular_deg: float) -> bool:
    apart = (measurement.illumination_deg - illumination_deg, measurement.aspecular_deg - aspecular_deg)
    return max(map(abs, apart)) <= SAME_DEG


def readings_like(standard: Standard, like: Paint) -> tuple[Measurement, ...]:
    """Return the standard's colours at the angles of ``like``, in the range of a paint's readings.

    Raises :class:`SuiteError`: it has no colour at one of the angles; the message names it.
    """
    measurements = []
    for m in like.measurements:
        found = standard.lab_at(m.illumination_deg, m.aspecular_deg)
        if found is None:
            raise SuiteError(
                f"{standard.name} has no reading at {Geometry(m.illumination_deg, m.aspecular_deg).name}, and nothing "
                "that one could be computed from."
            )
        measurements.append(replace(m, lab=within_paint(found[0])))
    return tuple(measurements)


def paint_like(standard: Standard, like: Paint) -> Paint:
    """Return the standard as a paint of the same angles as ``like``, to be edited, or swapped with it.

    A standard that is a paint is that paint. Of anything else the colours are its own; what it does not know (gloss,
    flakes, the rule between the angles) is that of ``like``.

    Raises :class:`SuiteError`: it has no colour at one of the angles; the message names it.
    """
    if standard.paint is not None:
        return standard.paint
    return replace(
        like,
        name=standard.name[:200] or like.name,
        measurements=readings_like(standard, like),
        gloss=standard.gloss or like.gloss,
        source=standard.origin,
        notes="",
    )
