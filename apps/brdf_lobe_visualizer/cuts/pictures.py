"""The images of the slices, made from one subject: a frozen request in, a grid of pictures out; runs on a thread.

The first row is the target, the second its fit (figure 4 of the paper); a third the difference, where differences are
shown: of the fit, or against the subject that differences are taken against.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from brdf_qt.program.translation import decimal, tr

from brdf_lobe_visualizer.cuts.images import Axes, Grid, Picture, ScaleBar
from brdf_lobe_visualizer.subjects.subjects import Measured, SamplePoints
from brdf_lobe_visualizer.words import UNIT, plain
from brdf_suite.arrays import Bools, Bytes, Floats
from brdf_suite.inspection.lobe_surface.colour import difference_map, value_map
from brdf_suite.inspection.slices.images import (
    DECADES,
    Pairs,
    Tone,
    colour_codes,
    image_error,
    image_of,
    mapped_codes,
    share_of,
)
from brdf_suite.inspection.slices.values import Channel, Cosine, channel_of, nice_above
from brdf_suite.progress import Progress, report

_BAR_STEPS = 128


@dataclass(frozen=True, eq=False)
class Request:
    """What is wanted: pictures of ``reflectance`` for each of ``pairs``, a column each.

    ``weights`` are its fit's, None where it has none; ``other`` is what differences are taken against, with its title.
    ``places`` gives the shares (k, 2) of width and height at which samples lie in a column, None where there are none.
    """

    title: str
    reflectance: Any
    weights: Any | None
    other: tuple[str, Any] | None
    difference: bool
    measured: Measured | None
    samples: SamplePoints | None
    pairs: tuple[Pairs, ...]
    columns: tuple[str, ...]
    channel: Channel
    cosine: Cosine
    tone: Tone
    ev: float
    quantity: str
    axes: Axes
    places: Callable[[SamplePoints, int], Floats] | None = None

    def gives_same(self, other: Request) -> bool:
        plain = ("title", "difference", "columns", "channel", "cosine", "tone", "ev", "quantity", "axes")
        one, two = (
            (r.reflectance, r.measured, r.samples, r.other and r.other[1], *r.pairs) for r in (self, other)
        )
        return (
            all(getattr(self, name) == getattr(other, name) for name in plain)
            and len(one) == len(two)
            and all(a is b for a, b in zip(one, two, strict=True))
            and _same_weights(self.weights, other.weights)
        )


def _same_weights(first: Any, second: Any) -> bool:
    # With lobes switched off they are made anew each time.
    if first is None or second is None or first is second:
        return first is second
    names = ("exponents", "kd", "kdd", "kg")
    return all(np.array_equal(getattr(first, name), getattr(second, name)) for name in names)


def make_grid(request: Request, progress: Progress | None = None) -> Grid:
    """Return the pictures; raises :class:`Cancelled` where the progress callback asks for it."""
    columns = range(len(request.pairs))
    targets = []
    for column in columns:
        report(progress, column / len(columns), request.title)
        targets.append(image_of(request.reflectance, request.pairs[column], cosine=request.cosine))
    fits = None
    if request.weights is not None:
        report(progress, 0.5, request.title)
        fits = [image_of(request.weights, pairs, cosine=request.cosine) for pairs in request.pairs]
    white = _white(targets, request)
    holes: list[Bools | None] = [None] * len(columns)
    if request.measured is not None:
        holes = [~request.measured(np.broadcast_to(p.wi, p.wo.shape), p.wo) & p.above for p in request.pairs]
    rows = [tr("target")]
    pictures = {
        (0, column): _picture(targets[column], request, white, column, holes[column], first=True)
        for column in columns
    }
    if fits is not None:
        rows.append(tr("fit"))
        for column in columns:
            error = image_error(targets[column], fits[column])
            notes: tuple[str, ...] = ()
            if error is not None:
                share = decimal(f"{100.0 * error.relative:.{0 if error.relative >= 0.1 else 1}f}")
                share = share if np.isfinite(error.relative) else "–"
                notes = (tr("RMS {share} %").format(share=share), f"{share} %")
            pictures[1, column] = _picture(fits[column], request, white, column, None, notes=notes)
    if request.difference:
        title, pictures_of = _differences(request, targets, fits, len(rows))
        if pictures_of:
            rows.append(title)
            pictures |= pictures_of
    return Grid(tuple(rows), request.columns, pictures, _bar(request, white), request.axes)


def _differences(
    request: Request, targets: list[Floats], fits: list[Floats] | None, row: int
) -> tuple[str, dict[tuple[int, int], Picture]]:
    if request.other is not None:
        name, reflectance = request.other
        others = [image_of(reflectance, pairs, cosine=request.cosine) for pairs in request.pairs]
        values = [channel_of(a - b, request.channel) for a, b in zip(targets, others, strict=True)]
        title = tr("− {name}").format(name=name)
    elif fits is not None:
        values = [channel_of(b - a, request.channel) for a, b in zip(targets, fits, strict=True)]
        title = tr("fit − target")
    else:
        return "", {}
    known = np.concatenate([np.abs(value[np.isfinite(value)]) for value in values])
    # Half of the pixels in a hundred may end beyond the map: one spike would leave all else grey.
    end = float(np.quantile(known, 0.995)) if known.size else 0.0
    end = nice_above(end) if end > 0.0 else 1.0
    pictures = {}
    for column, (value, pairs) in enumerate(zip(values, request.pairs, strict=True)):
        codes = mapped_codes(np.clip(0.5 + 0.5 * value / end, 0.0, 1.0), difference_map())
        pictures[row, column] = Picture(codes, value, ~pairs.above, _not_finite(value, pairs))
    return f"{title}  (±{plain(end)})", pictures


def _picture(
    value: Floats,
    request: Request,
    white: float,
    column: int,
    holes: Bools | None,
    *,
    notes: tuple[str, ...] = (),
    first: bool = False,
) -> Picture:
    one = channel_of(value, request.channel)
    if request.channel == "colour":
        codes = colour_codes(value, request.tone, white)
    else:
        codes = mapped_codes(share_of(one, request.tone, white), value_map())
    pairs = request.pairs[column]
    gone = _not_finite(one, pairs)
    if holes is not None:
        gone = holes if gone is None else gone | holes
    points = None
    if first and request.samples is not None and request.places is not None:
        points = request.places(request.samples, column)
    if first and gone is not None and gone.any():
        notes = (tr("hatched: not measured"), tr("holes"))
    return Picture(codes, one, ~pairs.above, gone, points, notes)


def _not_finite(value: Floats, pairs: Pairs) -> Bools | None:
    gone = ~np.isfinite(value) & pairs.above
    return gone if gone.any() else None


def _white(targets: list[Floats], request: Request) -> float:
    """Return the value that is white: so that the flank of a highlight is seen, and not the highlight alone."""
    values = np.concatenate([channel_of(target, request.channel).ravel() for target in targets])
    lit = values[np.isfinite(values) & (values > 0.0)]
    if not lit.size:
        return 1.0
    top = float(lit.max())
    usual = float(np.median(lit)) * 100.0 if request.tone == "log" else float(np.quantile(lit, 0.9))
    return float(nice_above(min(top, usual)) * 2.0**-request.ev)


def _bar(request: Request, white: float) -> ScaleBar:
    codes: Bytes = value_map()
    if request.channel == "colour":
        codes = np.repeat(np.linspace(0, 255, _BAR_STEPS).round().astype(np.uint8)[:, None], 3, axis=1)
    decades = [10.0 ** (-k) for k in range(int(DECADES) + 1)]
    values = [white * share for share in (decades if request.tone == "log" else (1.0, 0.5, 0.2, 0.05, 0.0))]
    ticks = tuple((float(share_of(value, request.tone, white)), plain(value)) for value in values)
    title = request.quantity if request.quantity.endswith(f"({UNIT})") else f"{request.quantity} ({UNIT})"
    return ScaleBar(codes, ticks, title)
