"""Settings of a simulated rig, and its misalignments."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal, get_args

from brdf_suite.documents.parameter import Parameter, check_choice, describe, set_numbers
from brdf_suite.errors import ValueRangeError

Curve = Literal["film", "linear", "srgb"]
CURVES: tuple[str, ...] = get_args(Curve)
FileKind = Literal["png", "tiff"]
FILE_KINDS: tuple[str, ...] = get_args(FileKind)

PARAMETERS: Mapping[str, Parameter] = MappingProxyType(
    {
        "shortest_s": Parameter("Shortest exposure", "s", 1e-6, 3600.0, 0.00025, ""),
        "longest_s": Parameter("Longest exposure", "s", 1e-6, 3600.0, 0.328, ""),
        "light_offset_deg": Parameter("Lamp offset", "°", -10.0, 10.0, 0.0, "Of the turntable's zero"),
        "light_height_offset_m": Parameter("Lamp height offset", "m", -0.2, 0.2, 0.0, "Above what is stated"),
        "camera_distance_m": Parameter("Camera distance", "m", 0.2, 100.0, 0.9, "From the axis"),
        "camera_height_m": Parameter(
            "Camera height", "m", -10.0, 10.0, 0.0, "The camera is tilted to the sphere"
        ),
        "light_distance_m": Parameter("Lamp distance", "m", 0.1, 100.0, 0.55, "From the axis"),
        "light_height_m": Parameter("Lamp height", "m", -10.0, 10.0, 0.0, "Above the sphere's centre"),
        "radius_m": Parameter("Radius", "m", 0.001, 1.0, 0.06, "Of the sphere"),
        "fill": Parameter(
            "Fill", "", 0.1, 0.95, 0.85, "Diameter of the sphere over the picture's shorter side"
        ),
        "distortion": Parameter(
            "Distortion", "", -0.05, 0.05, -0.004, "At the corner, of the distance to it"
        ),
        "vignetting": Parameter("Vignetting", "", 0.0, 0.9, 0.05, "Loss of light at the corner"),
        "full_well": Parameter("Full well", "e", 100.0, 1e7, 30_000.0, "Electrons at full scale"),
        "read_noise": Parameter("Read noise", "e", 0.0, 1000.0, 6.0, "Root mean square"),
        "dark_current": Parameter("Dark current", "e/s", 0.0, 1e5, 3.0, "Mean of all pixels"),
        "gain_spread": Parameter("Gain spread", "", 0.0, 0.2, 0.01, "From pixel to pixel, root mean square"),
    }
)


@dataclass(frozen=True)
class SimulatorSettings:
    """Settings of a simulated rig; the defaults follow Günther et al. 2005, section 3, as far as it is described.

    Attributes
    ----------
    size
        (width, height) of the photographs.
    positions, angles_deg
        Either so many angles, evenly from 0° by 180°/positions, or these, ascending.
    exposures, shortest_s, longest_s
        A geometric series of times.
    bit_depth, curve
        Codes of 8 to 16 bits; the response: ``film`` (a soft curve, another one for each channel, that is
        not stated), ``linear``, or ``srgb``.
    noise
        Shot and read noise, dark current, hot pixels, and a gain that differs between pixels; off: none of these.
    light_offset_deg, light_height_offset_m, centre_offset_px, moved
        Differences from the session: the lamp's angle and height are off, the sphere is off by (right, down) in the
        picture, and from position ``moved[0]`` on by ``moved[1:]`` more.
    state_centre
        State the sphere's centre in the session, as if it stood on the axis.
    white, dark, flat_field
        Whether these photographs are taken. Without the white reference the session states the irradiance.
    board
        Photograph a chessboard; else the session states the intrinsics.
    arm
        The lamp's housing and post hide what is behind them, and the coat mirrors the turntable in its lower half.
    profile
        A lamp that falls off to the sides, stated in the session.
    colour_matrix
        A camera whose channels are not those of the working space; the session states the matrix.
    """

    size: tuple[int, int] = (320, 320)
    positions: int = 180
    angles_deg: tuple[float, ...] = ()
    exposures: int = 16
    shortest_s: float = 0.00025
    longest_s: float = 0.328
    bit_depth: int = 12
    curve: Curve = "film"
    noise: bool = True
    seed: int = 0
    light_offset_deg: float = 0.0
    light_height_offset_m: float = 0.0
    centre_offset_px: tuple[float, float] = (0.0, 0.0)
    moved: tuple[int, float, float] | None = None
    state_centre: bool = False
    white: bool = True
    dark: bool = True
    flat_field: bool = True
    board: bool = True
    arm: bool = False
    profile: bool = False
    colour_matrix: bool = False
    radius_m: float = 0.06
    camera_distance_m: float = 0.9
    camera_height_m: float = 0.0
    light_distance_m: float = 0.55
    light_height_m: float = 0.0
    fill: float = 0.85
    distortion: float = -0.004
    vignetting: float = 0.05
    full_well: float = 30_000.0
    read_noise: float = 6.0
    dark_current: float = 3.0
    gain_spread: float = 0.01
    file_kind: FileKind = "png"

    def __post_init__(self) -> None:
        set_numbers(self, PARAMETERS, *PARAMETERS)
        for i, side in enumerate(self.size):
            if not 16 <= side <= 16_384:
                raise ValueRangeError(f"size[{i}]", f"{side} is outside the range 16 to 16384")
        check_choice(self.curve, "curve", CURVES)
        check_choice(self.file_kind, "file_kind", FILE_KINDS)
        whole = {"positions": (1, 3600), "exposures": (1, 64), "bit_depth": (8, 16), "seed": (0, 2**31 - 1)}
        for name, (low, high) in whole.items():
            value = getattr(self, name)
            if isinstance(value, bool) or not isinstance(value, int) or not low <= value <= high:
                raise ValueRangeError(name, f"{describe(value)} is no whole number from {low} to {high}")
        if self.longest_s <= self.shortest_s and self.exposures > 1:
            raise ValueRangeError("longest_s", "must be longer than the shortest exposure")
        if self.moved is not None and not 0 < self.moved[0] < len(self.angles()):
            raise ValueRangeError("moved", f"position {self.moved[0]} is not one of the later ones")
        shifts = {
            "centre_offset_px": self.centre_offset_px,
            "moved": () if self.moved is None else self.moved[1:],
        }
        for name, shift in shifts.items():
            # A NaN is not within either.
            if not all(abs(pixels) <= max(self.size) for pixels in shift):
                raise ValueRangeError(name, f"{max(self.size)} pixels, the picture's size, are the most")

    def angles(self) -> tuple[float, ...]:
        """Return the lamp's angles in degrees, as the session states them."""
        if self.angles_deg:
            return self.angles_deg
        return tuple(180.0 * i / self.positions for i in range(self.positions))

    def exposures_s(self) -> tuple[float, ...]:
        """Return the exposure times in seconds, to six digits as a camera records them."""
        if self.exposures == 1:
            return (self.shortest_s,)
        step = math.log(self.longest_s / self.shortest_s) / (self.exposures - 1)
        return tuple(float(f"{self.shortest_s * math.exp(step * k):.6g}") for k in range(self.exposures))
