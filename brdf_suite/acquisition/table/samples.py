"""BRDF samples from one merged photograph: each pixel of the sphere has its own pair of directions.

f_r = radiance / (E cosθi), where E, the irradiance of a surface that faces the light, is that at the turntable's axis
times (distance of the axis / distance of the point)² times the lamp's intensity in that direction over the one along
its axis.

What counts as a sample
    The upper half alone, where also the mirrored way goes upward: a level camera sees arm and turntable mirrored in
    the lower half only. Not where the mask, the lamp's housing or its post hide the sphere, nor where θi or θo exceed
    the grazing limit: there a pixel covers 1/cosθo as much of the sphere, 1/cosθi magnifies what the normal's error
    does to the irradiance, and the outline's blur mixes in the dark behind.

What a pixel covers
    A pixel is a mean over its footprint. Where f_r is smooth over it, its middle represents it. Near the peak of a
    clearcoat it is not: at 900 pixels across the sphere one pixel covers 0.13° of θh, a dozen bins of a table at its
    finest. There (θh < ``peak_deg``) each pixel is read in ``parts``² parts. How its radiance is divided among them
    follows a Gaussian on a base through its neighbours, sharpened by the pixel's own square (see
    :func:`~brdf_suite.acquisition.table.samples_kernel.lobe_through`), and keeps the pixel's mean: noise does
    not grow. Each part has its own directions. The lens's blur is not undone.

Everything that does not change with the light is computed once, for the pixels that can be samples; then a position
is one pass over these.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry, unit
from brdf_suite.acquisition.table import samples_kernel
from brdf_suite.arrays import AnyArray, Bools, Floats, Singles
from brdf_suite.errors import ValueRangeError

GRAZING_DEG = 80.0
PEAK_DEG = 3.0
PARTS = 4

_BLOCK = 1 << 18


@dataclass(frozen=True)
class PositionSamples:
    """BRDF samples from one position of the light: n samples, by rising pixel.

    Attributes
    ----------
    wi, wo
        (n, 3) float32, to the light and to the camera, in the surface's frame: z is the normal, ``wo`` lies in the
        half plane y = 0, x ≥ 0.
    value
        (n, 3) float32, f_r in 1/sr without cosine, in the camera's channels. Noise may make it negative.
    variance
        (n, 3) float32 of ``value``; zeros where none was given.
    weight
        (n,) float32: the share of a pixel, 1, or 1/parts² near the peak.
    half_angle
        (n, 3) float32, θh, θd and φd in radians, φd in [0, π).
    footprint
        (n,) float32, half of the range of θh over the sample, radians.
    pixel
        (n,) int32, row · width + column in the whole photograph.
    """

    wi: Singles
    wo: Singles
    value: Singles
    variance: Singles
    weight: Singles
    half_angle: Singles
    footprint: Singles
    pixel: npt.NDArray[np.int32]

    def __len__(self) -> int:
        return len(self.value)


class SphereSampler:
    """Sampler of the sphere's pixels, position by position.

    Parameters
    ----------
    geometry
        The refined rig. Without an irradiance 1 is taken, and values are right but for one factor per channel.
    mask
        (h, w), True: may be used; None: all.
    grazing_deg
        Largest θi and θo of a sample, degrees, less than 90.
    upper_half
        Leave out what faces down.
    peak_deg, parts
        Pixels with θh below this are read in ``parts`` × ``parts`` parts; 0 or 1: none are.

    Raises
    ------
    ValueRangeError
        An angle out of its range, or a mask of another size.
    """

    def __init__(
        self,
        geometry: RigGeometry,
        mask: Bools | None = None,
        grazing_deg: float = GRAZING_DEG,
        *,
        upper_half: bool = True,
        peak_deg: float = PEAK_DEG,
        parts: int = PARTS,
    ) -> None:
        if not 0.0 < grazing_deg < 90.0:
            raise ValueRangeError("grazing_deg", f"{grazing_deg:g}°; expected above 0° and below 90°")
        if mask is not None and mask.shape != geometry.shape:
            sizes = (f"{shape[1]} × {shape[0]}" for shape in (mask.shape, geometry.shape))
            raise ValueRangeError("mask", "{} pixels; the photographs have {}".format(*sizes))
        self.geometry = geometry
        self._least = math.cos(math.radians(grazing_deg))
        self._peak = math.radians(peak_deg)
        self._parts = max(int(parts), 1)
        self._prepare(mask, upper_half)

    def _prepare(self, mask: Bools | None, upper_half: bool) -> None:
        """Keep what each pixel that can be a sample sees of the sphere."""
        geometry = self.geometry
        height, width = geometry.shape
        outline = geometry.outline(np.linspace(0.0, 2.0 * math.pi, 720, endpoint=False))
        low = np.clip(np.floor(outline.min(axis=0)) - 1, 0, (width, height)).astype(int)
        high = np.clip(np.ceil(outline.max(axis=0)) + 2, low, (width, height)).astype(int)
        places = []
        step = max(1, _BLOCK // max(1, high[0] - low[0]))
        for first in range(low[1], high[1], step):
            x, y = np.meshgrid(np.arange(low[0], high[0]), np.arange(first, min(high[1], first + step)))
            usable = self._usable(np.stack((x, y), axis=-1), upper_half)
            if mask is not None:
                usable &= mask[y, x]
            places.append(np.stack((y[usable], x[usable]), axis=-1))
        self._places = np.concatenate(places).astype(np.int32) if places else np.empty((0, 2), np.int32)
        columns = self._places[:, ::-1].astype(float)
        points, normals, views = self._surface(columns)
        tangents = views - np.einsum("ni,ni->n", views, normals)[:, None] * normals
        lengths = np.linalg.norm(tangents, axis=-1)
        straight = lengths < 1e-9  # seen along the normal, any tangent will do
        tangents[straight] = np.cross(normals[straight], (1.0, 0.0, 0.0))
        tangents = unit(tangents) if len(tangents) else tangents
        right, down = np.array((0.5, 0.0)), np.array((0.0, 0.5))
        east = self._surface(columns + right)[1] - self._surface(columns - right)[1]
        south = self._surface(columns + down)[1] - self._surface(columns - down)[1]
        seen = (points, normals, tangents, views, np.concatenate((east, south), axis=-1))
        self._seen = tuple(array.astype(np.float32) for array in seen)
        self.box = (slice(0, 0), slice(0, 0))
        if len(self._places):
            # Two pixels more all round: the peak's shape is read off neighbours.
            top, left = np.maximum(self._places.min(axis=0) - 2, 0).tolist()
            bottom, right = np.minimum(self._places.max(axis=0) + 3, (height, width)).tolist()
            self.box = (slice(top, bottom), slice(left, right))

    def _surface(self, pixels: Floats) -> tuple[Floats, ...]:
        """Return points, normals and ways to the camera (..., 3) that pixels (..., 2) see."""
        rays, points, _ = self.geometry.meet(pixels)
        return points, (points - self.geometry.centre) / self.geometry.radius_m, -rays

    def _usable(self, pixels: npt.NDArray[np.int_], upper_half: bool) -> Bools:
        """Return which pixels (..., 2) see the sphere, its upper half, and not too slantwise."""
        _, normals, views = self._surface(pixels.astype(float))
        cosine = np.einsum("...i,...i", normals, views)
        # Beyond the outline the points lie off the sphere, and their normals are longer than 1.
        usable = (cosine >= self._least) & (np.abs(np.linalg.norm(normals, axis=-1) - 1.0) < 1e-6)
        if upper_half:
            up = unit(self.geometry.up)
            rising = normals @ up
            usable &= (rising > 0.0) & (2.0 * cosine * rising - views @ up >= 0.0)
        return np.asarray(usable)

    def __len__(self) -> int:
        """Return how many pixels can be samples."""
        return len(self._places)

    @property
    def used(self) -> Bools:
        """Return the pixels that can be samples (h, w)."""
        shown = np.zeros(self.geometry.shape, bool)
        shown[self._places[:, 0], self._places[:, 1]] = True
        return shown

    def samples(
        self,
        k: int,
        radiance: Singles,
        variance: Singles | None = None,
        good: Bools | None = None,
    ) -> PositionSamples:
        """Return the samples of position ``k``.

        Parameters
        ----------
        k
            Index of the light's position.
        radiance
            (h, w, 3) float32 of the whole photograph, or of :attr:`box` alone; the photographs' unit per second.
        variance
            Of ``radiance``, as large.
        good
            (h, w), False: clipped or not known.

        Raises
        ------
        ValueRangeError
            Pictures of another size.
        """
        places = self._local_places(radiance.shape[:2])
        radiance = np.ascontiguousarray(radiance, np.float32)
        noise = np.empty((0, 0, 3)) if variance is None else variance
        known = np.empty((0, 0)) if good is None else good
        for name, picture in (("variance", noise), ("good", known)):
            if picture.shape[0] and picture.shape[:2] != radiance.shape[:2]:
                reason = f"{picture.shape[:2]} rows and columns; {radiance.shape[:2]} wanted"
                raise ValueRangeError(name, reason)
        pictures = (radiance, np.ascontiguousarray(noise, np.float32), np.ascontiguousarray(known, bool))
        lamp = self._lamp(k)
        irradiance = np.array(self.geometry.irradiance_rgb or (1.0, 1.0, 1.0))
        scratch = np.zeros(32 + 3 * self._parts**2)
        whole = _made(len(places))
        common = (self._least, irradiance, scratch)
        count = samples_kernel.read_pixels(places, self._seen, pictures, lamp, *common, whole)
        whole = tuple(array[:count] for array in whole)
        *_, half_angle, footprint, index = whole
        near = index[half_angle[:, 0] < self._peak]
        if self._parts < 2 or not len(near):
            return self._samples(whole, np.ones(count, np.float32))
        fine = _made(len(near) * self._parts**2)
        seen = (near, places, self._seen, pictures, lamp)
        count = samples_kernel.read_parts(*seen, self.geometry.radius_m, self._parts, *common, fine)
        fine = tuple(array[:count] for array in fine)
        fine[-2][:] = footprint[np.searchsorted(index, fine[-1])] / self._parts
        kept = ~np.isin(index, fine[-1])
        weight = np.full(np.count_nonzero(kept) + count, 1.0 / self._parts**2, np.float32)
        weight[: np.count_nonzero(kept)] = 1.0
        both = [np.concatenate((a[kept], b)) for a, b in zip(whole, fine, strict=True)]
        order = np.argsort(both[-1], kind="stable")
        return self._samples([array[order] for array in both], weight[order])

    def _samples(self, made: Sequence[AnyArray], weight: Singles) -> PositionSamples:
        wi, wo, value, variance, half_angle, footprint, index = made
        places = self._places[index]
        pixel = places[:, 0] * np.int32(self.geometry.shape[1]) + places[:, 1]
        return PositionSamples(wi, wo, value, variance, weight, half_angle, footprint, pixel)

    def _local_places(self, shape: tuple[int, ...]) -> npt.NDArray[np.int32]:
        """Return row and column of the pixels in the whole photograph, or in the box."""
        if tuple(shape) == self.geometry.shape:
            return self._places
        rows, columns = self.box
        if tuple(shape) == (rows.stop - rows.start, columns.stop - columns.start):
            return self._places - np.array((rows.start, columns.start), np.int32)
        wanted = f"{self.geometry.shape} of a photograph or those of the box wanted"
        raise ValueRangeError("radiance", f"{shape[0]} rows and {shape[1]} columns; {wanted}")

    def _lamp(self, k: int) -> tuple[Floats, ...]:
        """Return the lamp's place, axis and squared distance, its profile, down, and what hides."""
        geometry = self.geometry
        place = geometry.light(geometry.angles_deg[k])
        aim = geometry.axis_point - place
        lamp = np.concatenate((place, unit(aim), [float(aim @ aim)]))
        table = np.array(geometry.profile or ((0.0, 1.0),)).T.copy()
        table[0] = np.radians(table[0])
        table[1] /= table[1, 0]
        return lamp, table, -unit(geometry.up), np.array((geometry.housing_radius_m, geometry.post_radius_m))


def _made(count: int) -> tuple[AnyArray, ...]:
    """Return room for samples as the kernels fill it: wi, wo, value, variance, half_angle, footprint, place."""
    rows = (np.zeros((count, 3), np.float32) for _ in range(5))
    return (*rows, np.zeros(count, np.float32), np.zeros(count, np.int32))
