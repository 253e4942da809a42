"""Street trees: a trunk that divides, branches that bend, and clusters of leaves at the ends of the twigs."""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from environments.solids import Solid, join, srgb, tube

_TINTS = 24


def _leaves(tips: Floats, random: np.random.Generator, per_tip: int, reach: float, size: float) -> Solid:
    """Return leaves about the tips of twigs: two triangles each along a bent midrib, hanging to all sides."""
    count = len(tips) * per_tip
    ball = random.normal(size=(count, 3))
    ball *= (random.random((count, 1)) ** 0.45) / np.linalg.norm(ball, axis=1, keepdims=True)
    base = np.repeat(tips, per_tip, axis=0) + ball * np.array([reach, 0.75 * reach, reach])
    along = random.normal(size=(count, 3)) + np.array([0.0, -0.45, 0.0])
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    across = np.cross(along, random.normal(size=(count, 3)) * 0.6 + [0.0, 1.0, 0.0])
    across /= np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-6)
    length = size * random.uniform(0.7, 1.25, (count, 1))
    wide = 0.42 * length
    points = np.stack(
        [
            base,
            base + 0.45 * length * along + wide * across,
            base + length * along,
            base + 0.45 * length * along - wide * across,
        ],
        axis=1,
    )
    first = np.arange(count)[:, None] * 4
    faces = np.concatenate([first + np.array([0, 1, 2]), first + np.array([0, 2, 3])])
    low, high = srgb("#3c5420"), srgb("#7f9a3c")
    share = np.round(np.clip(random.normal(0.42, 0.2, count), 0, 1) * (_TINTS - 1)) / (_TINTS - 1)
    colours = low * (1 - share[:, None]) + high * share[:, None]
    return Solid(
        points.reshape(-1, 3),
        faces.astype(np.int64),
        np.zeros((4 * count, 2)),
        np.concatenate([colours, colours]),
    )


def tree(seed: int, height: float, per_tip: int = 70) -> tuple[Solid, Solid]:
    """Return wood and leaves of a tree of a height in metres, its trunk free up to a third of it."""
    random = np.random.default_rng(seed)
    wood: list[Solid] = []
    tips: list[Floats] = []
    grey = srgb("#7a7364")

    def grow(start: Floats, toward: Floats, length: float, radius: float, level: int) -> None:
        steps = 6
        path = [start]
        direction = toward / np.linalg.norm(toward)
        for _ in range(steps):
            direction = (
                direction + random.normal(0, 0.1 if level else 0.025, 3) + [0.0, 0.05 if level else 0.0, 0.0]
            )
            direction = direction / np.linalg.norm(direction)
            path.append(path[-1] + direction * length / steps)
        places = np.array(path)
        end = radius * (0.62 if level else 0.72)
        wood.append(
            tube(
                places,
                np.linspace(radius * (1.15 if level == 0 else 1.0), end, len(places)),
                grey,
                12 if level < 2 else 6,
            )
        )
        if level == 4:
            tips.append(places[-1])
            tips.append(places[3])
            return
        children = (4, 4, 4, 3)[level]
        turn = random.uniform(0, 2 * np.pi)
        for k in range(children):
            angle = turn + 2 * np.pi * k / children + random.normal(0, 0.3)
            lean = random.uniform(0.45, 0.95) if k or level > 1 else 0.15
            side = np.cross(direction, [np.sin(angle), 0.1, np.cos(angle)])
            side = side / np.linalg.norm(side)
            at = places[-1] if level == 0 or k < 2 else places[int(random.integers(3, steps))]
            grow(
                at,
                direction * np.cos(lean) + side * np.sin(lean),
                length * random.uniform(0.58, 0.76),
                end * 0.72,
                level + 1,
            )

    grow(np.zeros(3), np.array([0.0, 1.0, 0.0]), 0.34 * height, 0.024 * height, 0)
    leaves = _leaves(np.array(tips), random, per_tip, 0.075 * height, 0.11)
    return join(wood), leaves
