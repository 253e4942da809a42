"""Simulated rig: its true geometry, its nominal session, the ground truth, and its photographs."""

from __future__ import annotations

import math
from dataclasses import asdict
from functools import cached_property

import numpy as np

from brdf_suite.acquisition.session.session import (
    Board,
    FlatField,
    Lens,
    Light,
    Position,
    Session,
    SessionCamera,
    Sphere,
    WhiteReference,
)
from brdf_suite.acquisition.simulator.optics import (
    HOUSING_RADIUS_M,
    POST_RADIUS_M,
    SimulatedCamera,
    SimulatedLamp,
    profile_table,
)
from brdf_suite.acquisition.simulator.picture import (
    BOARD_COLUMNS,
    BOARD_PICTURES,
    BOARD_ROWS,
    TILE_REFLECTANCE,
    SimulatedScene,
    board_picture,
    board_square_m,
    tile_picture,
    tile_region,
)
from brdf_suite.acquisition.simulator.sensor import Sensor, response
from brdf_suite.acquisition.simulator.settings import SimulatorSettings
from brdf_suite.arrays import Codes, Floats, Singles, triple
from brdf_suite.reflectance.protocol import Reflectance

WHITE_ANGLE_DEG = 30.0
TRUTH_FILE = "truth.json"
_CURVE_POINTS = 257
_LAMP_RGB = np.array([0.92, 1.0, 0.81])
_METER_ANGLE_DEG = 60.0
_BRIGHTEST = 0.7
"""Of the well, in the shortest exposure, at the angle where the photographer meters."""
_MIDDLING = 6.0
"""Fillings of the well in the longest exposure that a typical lit pixel has at most."""

_FROM_WORKING = np.array([[0.82, 0.13, 0.05], [0.06, 0.88, 0.06], [0.02, 0.15, 0.83]])
"""A camera's channels overlap: each sees something of all primaries, and never less than nothing."""

# The noise of each kind of photograph is its own.
_DARK_SHOT, _WHITE_SHOT, _FLAT_SHOT, _BOARD_SHOT = 10_000, 10_001, 10_002, 10_100


class Simulator:
    """A simulated rig with a sphere of one paint. It writes nothing; photographs are computed on demand.

    >>> from brdf_suite.reflectance.models.cook_torrance import CookTorrance
    >>> from brdf_suite.reflectance.models.table_1 import TABLE_1
    >>> paint = CookTorrance(TABLE_1["table1_polaris_silver"])
    >>> rig = Simulator(paint, SimulatorSettings(size=(64, 64), positions=3, exposures=4), "Polaris")
    >>> rig.position(1).shape
    (4, 64, 64, 3)
    """

    def __init__(
        self, reflectance: Reflectance, settings: SimulatorSettings | None = None, name: str = "paint"
    ) -> None:
        self.reflectance = reflectance
        self.settings = settings or SimulatorSettings()
        self.name = name
        self.sensor = Sensor.made(self.settings)
        self.optics = _optics(self.settings)

    @cached_property
    def session(self) -> Session:
        """The input of the reconstruction: the rig as intended, and the names of the files."""
        settings, ending = self.settings, {"png": ".png", "tiff": ".tif"}[self.settings.file_kind]
        exposures = settings.exposures_s()

        def series(stem: str, count: int = len(exposures)) -> tuple[str, ...]:
            return tuple(f"{stem}/{k:02d}{ending}" for k in range(count))

        board = white = stated = matrix = None
        if settings.colour_matrix:
            red, green, blue = np.linalg.inv(_FROM_WORKING)
            matrix = (triple(red), triple(green), triple(blue))
        if settings.board:
            square = board_square_m(self.optics, settings)
            board = Board(BOARD_COLUMNS, BOARD_ROWS, square, series("board", BOARD_PICTURES))
        if settings.white:
            region = tile_region(self.optics, settings)
            white = WhiteReference(series("white"), region, (TILE_REFLECTANCE,) * 3, WHITE_ANGLE_DEG)
        else:
            stated = triple(self._irradiance())
        camera = SessionCamera(
            settings.camera_distance_m,
            settings.camera_height_m,
            settings.bit_depth,
            "unknown" if settings.curve == "film" else settings.curve,
            math.degrees(_tilt(settings)),
            matrix,
            None if settings.board else self.optics.lens,
            board,
        )
        light = Light(
            settings.light_distance_m,
            settings.light_height_m,
            stated,
            profile_table() if settings.profile else (),
            housing_radius_m=HOUSING_RADIUS_M if settings.arm else 0.0,
            post_radius_m=POST_RADIUS_M if settings.arm else 0.0,
        )
        return Session(
            self.name,
            camera,
            Sphere(settings.radius_m, (0.0, 0.0, 0.0) if settings.state_centre else None),
            light,
            exposures,
            tuple(Position(angle, series(f"light_{k:04d}")) for k, angle in enumerate(settings.angles())),
            white,
            series("dark") if settings.dark else (),
            FlatField(series("flat_field", 1), (1.0,)) if settings.flat_field else None,
            notes="Simulated.",
        )

    @cached_property
    def truth(self) -> dict[str, object]:
        """The true rig as JSON data; the reconstruction does not see it.

        ``response`` holds codes and, for each, the exposure of the three channels in the photographs' unit.
        """
        positions = range(len(self.settings.angles()))
        filling = np.linspace(0.0, 1.0, _CURVE_POINTS)[:, None]
        black, white = self.sensor.black, 2**self.settings.bit_depth - 1
        codes = black + response(self.settings.curve, filling) * (white - black)
        exposures = filling * self.sensor.unit_rgb()
        return {
            "paint": self.name,
            "settings": asdict(self.settings),
            "intrinsics": asdict(self.optics.lens),
            "irradiance_rgb": self._irradiance().tolist(),
            "black_code": black,
            "response": {"codes": codes.T.tolist(), "exposures": exposures.T.tolist()},
            "sphere_centres_m": [self._centre(k).tolist() for k in positions],
            "lamps_m": [self.lamp(k).place.tolist() for k in positions],
        }

    def lamp(self, position: int) -> SimulatedLamp:
        """Return the lamp where it truly stands at a position."""
        return self._lamp(self.settings.angles()[position])

    def radiance(self, position: int) -> Singles:
        """Return (h, w, 3): the sphere's radiance as it is, without camera, in the photographs' unit per second."""
        unit = self._strength * self.sensor.unit_rgb()
        return (self._scene(position).mean_radiance(self.lamp(position)) * unit).astype(np.float32)

    def position(self, position: int) -> Codes:
        """Return the photographs of a position, (e, h, w, 3) codes, shortest exposure first."""
        picture = self._scene(position).mean_radiance(self.lamp(position)) * self._strength
        return self._photographed(picture, self.settings.exposures_s(), position)

    def dark(self) -> Codes:
        """Return the dark frames (e, h, w, 3)."""
        width, height = self.settings.size
        return self._photographed(np.zeros((height, width, 3)), self.settings.exposures_s(), _DARK_SHOT)

    def white(self) -> Codes:
        """Return the photographs (e, h, w, 3) of a white tile in the sphere's place."""
        picture = tile_picture(self.optics, self.settings, self._lamp(WHITE_ANGLE_DEG)) * self._strength
        return self._photographed(picture, self.settings.exposures_s(), _WHITE_SHOT)

    def flat_field(self) -> Codes:
        """Return one photograph (1, h, w, 3) of an even screen, well exposed."""
        width, height = self.settings.size
        return self._photographed(np.full((height, width, 3), 0.55), (1.0,), _FLAT_SHOT)

    def board(self, index: int) -> Codes:
        """Return a photograph (h, w, 3) of the chessboard, each in another place."""
        picture = board_picture(self.optics, self.settings, index)
        return self._photographed(picture, (1.0,), _BOARD_SHOT + index)[0]  # type: ignore[no-any-return]  # a row of codes

    @cached_property
    def _strength(self) -> Floats:
        """Return full wells per second of radiance 1 at irradiance 1, (3,): the lamp as set by the photographer."""
        lamp = self._unit_lamp(_METER_ANGLE_DEG)
        seen = self._scene(0).mean_radiance(lamp).mean(axis=-1)
        lit = seen[seen > 0.0]
        if not len(lit):
            return _LAMP_RGB
        shortest, longest = self.settings.shortest_s, self.settings.longest_s
        bright = _BRIGHTEST / (float(lit.max()) * shortest)
        return _LAMP_RGB * min(bright, _MIDDLING / (float(np.median(lit)) * longest))

    def _irradiance(self) -> Floats:
        return np.asarray(self._strength * self.sensor.unit_rgb())

    def _lamp(self, degrees: float) -> SimulatedLamp:
        return self._unit_lamp(degrees + self.settings.light_offset_deg)

    def _unit_lamp(self, degrees: float) -> SimulatedLamp:
        angle, settings = math.radians(degrees), self.settings
        distance = settings.light_distance_m
        height = settings.light_height_m + settings.light_height_offset_m
        place = np.array([distance * math.sin(angle), height, distance * math.cos(angle)])
        return SimulatedLamp(place, settings.profile)

    def _centre(self, position: int) -> Floats:
        """Return the true centre of the sphere at a position."""
        settings = self.settings
        right, down = settings.centre_offset_px
        if settings.moved is not None and position >= settings.moved[0]:
            right, down = right + settings.moved[1], down + settings.moved[2]
        scale = settings.camera_distance_m / self.optics.lens.fx
        return np.asarray((right * self.optics.turn[0] + down * self.optics.turn[1]) * scale)

    def _scene(self, position: int) -> SimulatedScene:
        settings, centre = self.settings, self._centre(position)
        matrix = _FROM_WORKING if settings.colour_matrix else None
        surface = (settings.radius_m, self.reflectance, matrix)
        return SimulatedScene(self.optics, settings.size, centre, *surface, settings.arm)

    @cached_property
    def _vignette(self) -> Floats:
        """Return vignetting (h, w, 1): the transmitted fraction, 1 in the middle of the picture."""
        width, height = self.settings.size
        rows, columns = np.mgrid[0.0:height, 0.0:width]
        away = (rows - 0.5 * (height - 1)) ** 2 + (columns - 0.5 * (width - 1)) ** 2
        off = away / (0.25 * (width**2 + height**2))
        return np.asarray((1.0 - self.settings.vignetting * off)[..., None])

    def _photographed(self, picture: Floats, exposures_s: tuple[float, ...], shot: int) -> Codes:
        return self.sensor.expose((picture * self._vignette).astype(np.float32), exposures_s, shot)


def _tilt(settings: SimulatorSettings) -> float:
    """Return the tilt that aims the camera at the origin."""
    return math.atan2(-settings.camera_height_m, settings.camera_distance_m)


def _optics(settings: SimulatorSettings) -> SimulatedCamera:
    width, height = settings.size
    away = math.hypot(settings.camera_distance_m, settings.camera_height_m)
    outline = math.tan(math.asin(settings.radius_m / away))
    focal = 0.5 * settings.fill * min(width, height) / outline
    corner = 0.5 * math.hypot(width, height) / focal
    # The principal point is never quite the middle of the picture.
    principal = (0.5 * (width - 1) + 0.004 * width, 0.5 * (height - 1) - 0.003 * height)
    lens = Lens(focal, focal, *principal, settings.distortion / corner**2)
    sine, cosine = math.sin(_tilt(settings)), math.cos(_tilt(settings))
    # The axis into the scene is (0, sin, -cos); right stays +x, and down is what completes a right-handed frame.
    turn = np.array([[1.0, 0.0, 0.0], [0.0, -cosine, -sine], [0.0, sine, -cosine]])
    centre = np.array([0.0, settings.camera_height_m, settings.camera_distance_m])
    return SimulatedCamera(centre, turn, lens)
