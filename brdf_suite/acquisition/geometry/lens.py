"""Pinhole camera with the lens distortion of Brown (1966), in OpenCV's parameterization.

The camera's frame has x to the right, y down and z forward, metres; a pixel's centre lies at whole numbers. With
a = x/z, b = y/z and s = a² + b²,

    a' = a (1 + k1 s + k2 s² + k3 s³) + 2 p1 a b + p2 (s + 2 a²)
    b' = b (1 + k1 s + k2 s² + k3 s³) + p1 (s + 2 b²) + 2 p2 a b

and the pixel is (fx a' + cx, fy b' + cy). Turned round, it is solved by Newton's method.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.session.values import PARAMETERS, set_numbers
from brdf_suite.arrays import Floats

_STEPS = 12
_CLOSE = 1e-13


@dataclass(frozen=True)
class Lens:
    """Focal lengths and principal point in pixels, and the coefficients of the distortion.

    >>> Lens(1000.0, 1000.0, 320.0, 240.0).pixels([0.1, 0.0, 1.0]).tolist()
    [420.0, 240.0]
    """

    fx: float
    fy: float
    cx: float
    cy: float
    k1: float = 0.0
    k2: float = 0.0
    p1: float = 0.0
    p2: float = 0.0
    k3: float = 0.0

    def __post_init__(self) -> None:
        set_numbers(self, PARAMETERS["focal"], "fx", "fy")
        set_numbers(self, PARAMETERS["principal"], "cx", "cy")
        set_numbers(self, PARAMETERS["distortion"], "k1", "k2", "p1", "p2", "k3")

    @property
    def distorts(self) -> bool:
        """Return whether any coefficient of the distortion differs from 0."""
        return any((self.k1, self.k2, self.p1, self.p2, self.k3))

    def pixels(self, points: npt.ArrayLike) -> Floats:
        """Return the pixels (..., 2) in which points (..., 3) of the camera's frame, before it, are seen."""
        points = np.asarray(points, float)
        plane = self._distorted(points[..., :2] / points[..., 2:])[0]
        return plane * (self.fx, self.fy) + (self.cx, self.cy)

    def rays(self, pixels: npt.ArrayLike) -> Floats:
        """Return the directions (..., 3) of unit length, away from the camera, that pixels (..., 2) see."""
        aim = (np.asarray(pixels, float) - (self.cx, self.cy)) / (self.fx, self.fy)
        plane = aim.copy()
        if self.distorts:
            for _ in range(_STEPS):
                value, (aa, ab, ba, bb) = self._distorted(plane)
                error = value - aim
                determinant = aa * bb - ab * ba
                step = np.stack(
                    (bb * error[..., 0] - ab * error[..., 1], aa * error[..., 1] - ba * error[..., 0]),
                    axis=-1,
                )
                plane -= step / determinant[..., None]
                if not np.any(np.abs(step) > _CLOSE):
                    break
        rays = np.concatenate((plane, np.ones((*plane.shape[:-1], 1))), axis=-1)
        unit: Floats = rays / np.linalg.norm(rays, axis=-1, keepdims=True)
        return unit

    def _distorted(self, plane: Floats) -> tuple[Floats, tuple[Floats, Floats, Floats, Floats]]:
        """Return (a', b') and the derivatives ∂a'/∂a, ∂a'/∂b, ∂b'/∂a, ∂b'/∂b."""
        a, b = plane[..., 0], plane[..., 1]
        s = a * a + b * b
        radial = 1.0 + s * (self.k1 + s * (self.k2 + s * self.k3))
        slope = 2.0 * (self.k1 + s * (2.0 * self.k2 + s * 3.0 * self.k3))  # of the radial factor, over a or b
        value = np.stack(
            (
                a * radial + 2.0 * self.p1 * a * b + self.p2 * (s + 2.0 * a * a),
                b * radial + self.p1 * (s + 2.0 * b * b) + 2.0 * self.p2 * a * b,
            ),
            axis=-1,
        )
        mixed = a * b * slope + 2.0 * self.p1 * a + 2.0 * self.p2 * b
        return value, (
            radial + a * a * slope + 2.0 * self.p1 * b + 6.0 * self.p2 * a,
            mixed,
            mixed,
            radial + b * b * slope + 6.0 * self.p1 * b + 2.0 * self.p2 * a,
        )

    def to_json(self) -> dict[str, float]:
        """Return the nine numbers under their names."""
        return asdict(self)
