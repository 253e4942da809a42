"""Ten thousand paints as a collection has them: around the shipped ones, in groups, no two alike."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

GROUPS = 25


def paints(count, seed=7):
    """Return so many designed paints."""
    from brdf_suite.documents.paint import Measurement
    from brdf_suite.pipeline.material import load_shipped_paint, paint_names

    rng = np.random.default_rng(seed)
    known = [load_shipped_paint(name) for name in paint_names()]
    found = []
    for index in range(count):
        paint = known[index % len(known)]
        turn = rng.uniform(0.0, 2.0 * np.pi)
        about = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
        lighter, purer = rng.uniform(0.85, 1.15), rng.uniform(0.4, 1.1)
        readings = []
        for m in paint.measurements:
            a, b = purer * (about @ np.array(m.lab[1:]))
            readings.append(
                Measurement(m.illumination_deg, m.aspecular_deg, (lighter * m.lab[0], float(a), float(b)))
            )
        found.append(replace(paint, name=f"{paint.name} {index:05d}", measurements=tuple(readings)))
    return found


def palette(count):
    """Return a palette of them, with codes, tags and dates."""
    from brdf_suite.documents.palette import Entry, Palette

    entries = []
    for index, paint in enumerate(paints(count)):
        entries.append(
            Entry(
                paint,
                id=f"{index:06d}",
                group=(f"Group {index * GROUPS // count + 1:02d}",),
                code=f"C-{index:05d}",
                tags=(("metallic", "solid", "trial")[index % 3],),
                date=f"20{10 + index % 15}-{1 + index % 12:02d}-{1 + index % 28:02d}",
            )
        )
    return Palette("Ten thousand", tuple(entries))
