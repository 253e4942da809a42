"""The lines of all visible subjects along the cuts that are shown: what the curves and the polar plot draw.

Numbers only, no widget. What has not changed is not evaluated again: a subject's values are kept with the reflectance
(or the lobes) and the cuts that they belong to.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import message_of

from brdf_lobe_visualizer.options import Options
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.subjects import Dash, PlottedMaterial, Srgb
from brdf_suite.arrays import Bools, Floats
from brdf_suite.inspection.slices.cuts import Slice
from brdf_suite.inspection.slices.values import (
    Cosine,
    SliceError,
    SlicePoints,
    channel_of,
    evaluate,
    points_near,
    slice_error,
    slices_csv,
)

Kind = Literal["target", "fit", "difference"]


@dataclass(frozen=True, eq=False)
class Line:
    """One line over a cut's angles: ``value`` (n,), NaN where there is nothing.

    ``filled`` (n,): values that a table's file does not have, filled in from their neighbours; None where all are
    measured or made. ``difference`` lines may be negative.
    """

    key: str
    title: str
    kind: Kind
    colour: Srgb
    dash: Dash
    is_front: bool
    value: Floats
    filled: Bools | None = None


@dataclass(frozen=True, eq=False)
class Lines:
    """All lines of one cut; ``points`` are the samples near it by subject, ``errors`` those of the fits by subject."""

    cut: Slice
    lines: tuple[Line, ...]
    points: dict[str, SlicePoints]
    errors: dict[str, SliceError]
    signed: bool
    """Whether differences are shown, which have a sign."""

    def reversed_over(self, cut: Slice, theta_deg: float) -> Lines:
        """Return the lines over ``cut``, the same directions the other way round: γ = ``theta_deg`` - θo."""
        lines = [
            replace(line, value=line.value[::-1], filled=None if line.filled is None else line.filled[::-1])
            for line in self.lines
        ]
        points = {key: replace(p, angle_deg=theta_deg - p.angle_deg) for key, p in self.points.items()}
        errors = {key: replace(e, worst_deg=theta_deg - e.worst_deg) for key, e in self.errors.items()}
        return Lines(cut, tuple(lines), points, errors, self.signed)


class SliceLines:
    """Evaluates subjects along cuts and keeps the values."""

    def __init__(self, session: LobeSession) -> None:
        self._session = session
        self._kept: dict[tuple[str, str], tuple[Any, tuple[Slice, ...], Cosine, list[Floats]]] = {}

    def of(self, cuts: Sequence[Slice]) -> list[Lines]:
        """Return the lines along each of the cuts; pass the same cuts to have nothing evaluated anew."""
        cuts = tuple(cuts)
        options = self._session.options
        subjects = self._session.visible
        values = {subject.key: self._values(subject, cuts, options) for subject in subjects}
        compared = self._session.reference
        against = None
        if options.shown == "difference" and compared is not None:
            target = self._session.target_of(compared)
            against = self._evaluated(compared, "target", target, cuts, options.cosine)
        keys = {subject.key for subject in self._session.subjects}
        self._kept = {at: kept for at, kept in self._kept.items() if at[0] in keys}
        return [
            self._lines(number, cut, subjects, values, None if against is None else against[number], options)
            for number, cut in enumerate(cuts)
        ]

    def _values(
        self, subject: PlottedMaterial, cuts: tuple[Slice, ...], options: Options
    ) -> tuple[list[Floats], list[Floats] | None]:
        whole = self._session.target_of(subject)
        target = self._evaluated(subject, "target", whole, cuts, options.cosine)
        weights = self._session.weights_of(subject) if options.shown != "target" else None
        if weights is None:
            return target, None
        # With lobes switched off the weights are made anew each time; compare what they are made of.
        mark = (subject.fit and subject.fit.weights, self._session.lobes_off(subject))
        return target, self._evaluated(subject, "fit", weights, cuts, options.cosine, mark)

    def _evaluated(
        self,
        subject: PlottedMaterial,
        which: str,
        reflectance: Any,
        cuts: tuple[Slice, ...],
        cosine: Cosine,
        mark: Any = None,
    ) -> list[Floats]:
        at, source = (subject.key, which), (reflectance,) if mark is None else mark
        kept = self._kept.get(at)
        if kept is not None and _same(kept[0], source) and _same(kept[1], cuts) and kept[2] == cosine:
            return kept[3]
        try:
            values = evaluate(reflectance, cuts, cosine=cosine)
        except Exception as error:  # noqa: BLE001 - an error of a model is reported, and the others are drawn
            self._session.messages.show_message(message_of(error, f"slices {subject.key} {which}"))
            values = [np.full((len(cut.angle_deg), 3), np.nan) for cut in cuts]
        self._kept[at] = (source, cuts, cosine, values)
        return values

    def _lines(
        self,
        number: int,
        cut: Slice,
        subjects: Sequence[PlottedMaterial],
        values: dict[str, tuple[list[Floats], list[Floats] | None]],
        against: Floats | None,
        options: Options,
    ) -> Lines:
        lines: list[Line] = []
        points: dict[str, SlicePoints] = {}
        errors: dict[str, SliceError] = {}
        front = self._session.front
        reference = None if against is None else channel_of(against, options.channel)
        for subject in subjects:
            targets, fits = values[subject.key]
            target = channel_of(targets[number], options.channel)
            fit = None if fits is None else channel_of(fits[number], options.channel)
            is_front = front is not None and subject.key == front.key
            filled = None if subject.measured is None else ~subject.measured(cut.wi, cut.wo)
            line = Line(
                subject.key, subject.title, "target", subject.colour, subject.dash, is_front, target, filled
            )
            error = None if fit is None else slice_error(cut.angle_deg, target, fit)
            if error is not None:
                errors[subject.key] = error
            if options.shown == "difference":
                # Against the compared one: how much more this one has. Against the fit: how much the fit has more.
                if reference is not None:
                    lines.append(replace(line, kind="difference", value=target - reference))
                elif fit is not None:
                    lines.append(replace(line, kind="difference", value=fit - target))
                continue
            if options.shown != "fit" or fit is None:
                lines.append(line)
            if fit is not None:
                lines.append(replace(line, kind="fit", value=fit, filled=None))
            if subject.samples is not None:
                near = points_near(
                    cut, subject.samples, isotropic=subject.samples.isotropic, cosine=options.cosine
                )
                points[subject.key] = SlicePoints(near.angle_deg, channel_of(near.value, options.channel))
        # Those of the front lie on top.
        lines.sort(key=lambda one: one.is_front)
        return Lines(cut, tuple(lines), points, errors, options.shown == "difference")


def _same(first: tuple[Any, ...], second: tuple[Any, ...]) -> bool:
    return len(first) == len(second) and all(
        a is b or (isinstance(a, frozenset) and a == b) for a, b in zip(first, second, strict=True)
    )


def largest(lines: Sequence[Line]) -> float:
    """Return the largest finite value of all lines, at least the smallest positive one that a plot can end at."""
    tops = [float(np.nanmax(np.abs(line.value))) for line in lines if np.isfinite(line.value).any()]
    top = max(tops, default=0.0)
    return top if top > 0.0 else 1.0


def csv_of(lines: Lines, angle: str, quantity: str, incidence_deg: tuple[float, float]) -> str:
    """Return the lines over their angle; ``angle`` and ``quantity`` name columns, with their units."""
    names = {"target": "{name}", "fit": tr("{name}, fit"), "difference": tr("{name}, difference")}
    columns: list[tuple[str, Floats]] = []
    for line in lines.lines:
        columns.append((f"{names[line.kind].format(name=line.title)}: {quantity}", line.value))
        if line.filled is not None and line.filled.any():
            measured = np.where(line.filled, 0.0, 1.0)
            columns.append((tr("{name}: measured (1) or filled in (0)").format(name=line.title), measured))
    theta, phi = incidence_deg
    title = tr("Lobe Visualizer, incidence {theta}°, azimuth {phi}°").format(
        theta=f"{theta:g}", phi=f"{phi:g}"
    )
    return slices_csv(angle, lines.cut.angle_deg, columns, title)
