"""Input values of the renderer: mesh parts, prefiltered maps, lobe weights; frozen and checked."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, Literal, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brdf_suite.errors import ValueRangeError

MAX_LOBES = 64
"""Of a material, and maps of an environment; how many a material may have weights on, ``material/ramp.py`` says."""

Coat: TypeAlias = Literal["none", "dielectric", "facets", "metal", "sheet"]


@dataclass(frozen=True, eq=False)
class MeshPart:
    """Triangles that share one material.

    Attributes
    ----------
    name
        Named by errors.
    material
        The material that :meth:`Renderer.set_material` knows: ``paint``, ``glass`` …
    positions
        (n, 3) float32, world metres, y up.
    normals
        (n, 3) float32, about unit length; either side, the shader turns them to the viewer.
    triangles
        (k, 3) uint32, k ≥ 1, indices below n.
    uvs
        (n, 2) float32, lengths on the surface in millimetres; None where the mesh has none.
    light
        (n, 8): mean direction x, y, z of the light that arrives and the share, 0 to 1, of a uniform light's
        irradiance that does, without and with a floor under the mesh; (n, 16): the same for the back too, which
        otherwise sees as much; None where that is not known.
    """

    name: str
    material: str
    positions: NDArray[Any]
    normals: NDArray[Any]
    triangles: NDArray[Any]
    uvs: NDArray[Any] | None = None
    light: NDArray[Any] | None = None

    def __post_init__(self) -> None:
        positions = _finite(self.positions, np.float32, (-1, 3), f"part {self.name!r}: positions")
        normals = _finite(self.normals, np.float32, (len(positions), 3), f"part {self.name!r}: normals")
        triangles = np.ascontiguousarray(self.triangles)
        if triangles.ndim != 2 or triangles.shape[1] != 3 or triangles.dtype.kind not in "iu":
            raise ValueRangeError(f"part {self.name!r}: triangles", "expected whole numbers (k, 3)")
        if not len(triangles) or triangles.min() < 0 or triangles.max() >= len(positions):
            raise ValueRangeError(
                f"part {self.name!r}: triangles", f"1 or more, with indices 0 to {len(positions) - 1}"
            )
        object.__setattr__(self, "positions", positions)
        object.__setattr__(self, "normals", normals)
        object.__setattr__(self, "triangles", np.ascontiguousarray(triangles, np.uint32))
        if self.uvs is not None:
            uvs = _finite(self.uvs, np.float32, (len(positions), 2), f"part {self.name!r}: uvs")
            object.__setattr__(self, "uvs", uvs)
        if self.light is not None:
            sides = 2 if np.shape(self.light)[1:] == (16,) else 1
            light = _finite(self.light, np.float16, (len(positions), 8 * sides), f"part {self.name!r}: light")
            object.__setattr__(self, "light", light)


@dataclass(frozen=True, eq=False)
class GroundField:
    """The ground under a mesh, and the visible light from above at each of its places.

    Attributes
    ----------
    height
        Metres.
    low, high
        Lowest and highest (x, z) of the field's edges, metres.
    transfer
        (rows along z, columns along x, (degree + 1)²): ∫ V cosθ Y_lm dω with the harmonics of
        :mod:`brdf_suite.geometry.low_harmonics`; at the edges that of an open ground.
    """

    height: float
    low: tuple[float, float]
    high: tuple[float, float]
    transfer: NDArray[Any]

    def __post_init__(self) -> None:
        if not all(np.isfinite([self.height, *self.low, *self.high])) or np.any(
            np.less_equal(self.high, self.low)
        ):
            raise ValueRangeError(
                "ground", "expected a finite height and edges, the highest above the lowest"
            )
        shape = np.shape(self.transfer)
        if len(shape) != 3 or round(shape[2] ** 0.5) ** 2 != shape[2]:
            raise ValueRangeError("ground", f"expected (rows, columns, squared number), not {shape}")
        object.__setattr__(self, "transfer", _finite(self.transfer, np.float32, shape, "ground: transfer"))


_HALF_INFINITY = 0x7C00


@dataclass(frozen=True, eq=False)
class CubeFaces:
    """One cube map: radiance of the working space = ``faces`` times ``scale``.

    ``faces`` is (6, F, F, 3) float16 in the order +x, -x, +y, -y, +z, -z and with the rows and columns of
    OpenGL's cube maps (row = t, column = s), finite. ``scale`` > 0 keeps a sun inside half range.
    """

    faces: NDArray[Any]
    scale: float = 1.0

    def __post_init__(self) -> None:
        shape = np.shape(self.faces)
        if len(shape) != 4 or shape[0] != 6 or shape[1] != shape[2] or shape[3] != 3 or shape[1] < 1:
            raise ValueRangeError("faces", f"expected six square faces (6, F, F, 3), not {shape}")
        if not (np.isfinite(self.scale) and self.scale > 0):
            raise ValueRangeError("scale", f"expected a finite number above 0, not {self.scale!r}")
        object.__setattr__(self, "faces", _finite(self.faces, np.float16, (6, -1, shape[1], 3), "faces"))

    @property
    def size(self) -> int:
        """Texels along an edge of a face."""
        return int(self.faces.shape[1])


@dataclass(frozen=True, eq=False)
class EnvironmentMaps:
    """An environment, prefiltered with unit gain: one map per lobe exponent, two diffuse maps, the background.

    A constant environment of radiance 1 is 1 in every map. ``diffuse`` is the E = 1 map, which is irradiance
    over π when looked up at the normal; ``through_coat`` is the same for light that crosses a coat on its way in.
    """

    exponents: tuple[float, ...]
    lobes: tuple[CubeFaces, ...]
    diffuse: CubeFaces
    through_coat: CubeFaces
    background: CubeFaces

    def __post_init__(self) -> None:
        object.__setattr__(self, "exponents", check_exponents(self.exponents))
        object.__setattr__(self, "lobes", tuple(self.lobes))
        if len(self.lobes) != len(self.exponents):
            raise ValueRangeError("lobes", f"expected {len(self.exponents)} maps, not {len(self.lobes)}")


@dataclass(frozen=True, eq=False)
class WeightsOverAngle:
    """Weights fitted at several incidences, at the cosines N·V of :data:`look_up_table.RAMP_COSINES`.

    ``kd`` is (64, 3), ``kdd`` and ``kg`` are (64, m, 3) in 1/sr, finite and not negative. ``turned`` (3, 64, m, 3)
    weighs KDD's lobes where they are looked up instead, in the order of :data:`look_up_table.TURNS`. Weights by the
    view that are ``under_coat`` were fitted to the look-ups of light that crosses a coat on its way to the base.
    """

    kd: NDArray[Any]
    kdd: NDArray[Any]
    kg: NDArray[Any]
    turned: NDArray[Any]
    under_coat: bool = False

    def __post_init__(self) -> None:
        lobes = np.shape(self.kdd)[1] if np.ndim(self.kdd) == 3 else -1
        shapes = {"kd": (64, 3), "kdd": (64, lobes, 3), "kg": (64, lobes, 3), "turned": (3, 64, lobes, 3)}
        for name, shape in shapes.items():
            value = _finite(getattr(self, name), np.float64, shape, f"over_angle.{name}")
            if (value < 0).any():
                raise ValueRangeError(f"over_angle.{name}", "weights must not be negative")
            object.__setattr__(self, name, value)


@dataclass(frozen=True, eq=False)
class MaterialWeights:
    """Lobe weights of one material, in the sense of the lobe sum

    f_r (N·L) ≈ KD (N·L) + (N·L) Σ KDD_i (R·V)^E_i + Σ KG_i (R·V)^E_i.

    Attributes
    ----------
    exponents
        m lobe exponents, the same as the environment's maps.
    kd, kdd, kg
        (3,), (m, 3), (m, 3) in 1/sr, working space, finite and not negative.
    theta_fit_rad
        Incidence of the fit, 0 to below π/2; the Fresnel gains are 1 there.
    ior
        Index of refraction of a dielectric coat, 1 to 100; 1 is no coat.
    coat
        ``dielectric``: gloss follows F(θ)/F(θ_fit) and the base T(θ)²/T(θ_fit)²; ``facets``: gloss follows
        F(θ)/F(θ_fit), the base stays; ``metal``: gloss rises from its own albedo to 1 at grazing; ``sheet``: gloss
        follows R(θ)/R(θ_fit), R = 2 F/(1 + F), of a thin sheet; ``none``: the weights hold at every angle.
    over_angle
        Weights fitted at several incidences, which the mode ``multi_angle`` takes; None where there are none (yet).
    by_view
        Weights fitted for every angle of the view. Where there are some, they take the place of the single fit and
        of its gains, and of ``over_angle``, whenever look-ups are shifted and Fresnel is not off.
    transmittance
        Share, 0 to 1, that passes of the light which gloss does not send back; above 0 for what is seen through.
    """

    exponents: tuple[float, ...]
    kd: NDArray[Any]
    kdd: NDArray[Any]
    kg: NDArray[Any]
    theta_fit_rad: float = field(default=float(np.pi / 4))
    ior: float = 1.5
    coat: Coat = "dielectric"
    over_angle: WeightsOverAngle | None = None
    by_view: WeightsOverAngle | None = None
    transmittance: float = 0.0

    def __post_init__(self) -> None:
        exponents = check_exponents(self.exponents)
        object.__setattr__(self, "exponents", exponents)
        for name, shape in (("kd", (3,)), ("kdd", (len(exponents), 3)), ("kg", (len(exponents), 3))):
            value = _finite(getattr(self, name), np.float64, shape, name)
            if value.min() < 0:
                raise ValueRangeError(name, "weights must not be negative")
            object.__setattr__(self, name, value)
        if not 0 <= self.theta_fit_rad < np.pi / 2:
            raise ValueRangeError("theta_fit_rad", f"expected 0 to below π/2, not {self.theta_fit_rad!r}")
        if not 1 <= self.ior <= 100:
            raise ValueRangeError("ior", f"expected 1 to 100, not {self.ior!r}")
        if self.coat not in get_args(Coat):
            raise ValueRangeError("coat", f"expected one of {', '.join(get_args(Coat))}, not {self.coat!r}")
        if not 0 <= self.transmittance <= 1:
            raise ValueRangeError("transmittance", f"expected 0 to 1, not {self.transmittance!r}")


def check_exponents(exponents: ArrayLike) -> tuple[float, ...]:
    """Return the exponents as a tuple of 1 to :data:`MAX_LOBES` finite numbers, each ≥ 1, or raise."""
    array = np.atleast_1d(np.asarray(exponents, np.float64))
    if array.ndim != 1:
        raise ValueRangeError("exponents", f"expected one row of numbers, not {array.shape}")
    values: list[float] = array.tolist()
    if not 1 <= len(values) <= MAX_LOBES:
        raise ValueRangeError("exponents", f"1 to {MAX_LOBES} lobes are drawn, not {len(values)}")
    if not all(1 <= e < math.inf for e in values):
        raise ValueRangeError("exponents", "each must be finite and at least 1")
    return tuple(values)


def _finite(array: ArrayLike, dtype: type, shape: tuple[int, ...], place: str) -> NDArray[Any]:
    value: NDArray[Any] = np.ascontiguousarray(array, dtype)
    fits = value.ndim == len(shape) and all(
        want in (-1, got) for want, got in zip(shape, value.shape, strict=True)
    )
    if not fits:
        raise ValueRangeError(place, f"expected shape {shape}, not {value.shape}")
    if not _all_finite(value):
        raise ValueRangeError(place, "not every number is finite")
    return value


def _all_finite(value: NDArray[Any]) -> bool:
    """Whether every number is finite; maps of half floats are large, and compared as the integers they are."""
    # Half floats that are not negative order as their bits do, and infinity and what is no number come last.
    if value.dtype == np.float16 and value.size and int(value.view(np.uint16).max()) < _HALF_INFINITY:
        return True
    return bool(np.isfinite(value).all())
