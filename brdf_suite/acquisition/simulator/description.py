"""Descriptions of a simulated rig: the nominal session, and the ground truth."""

from __future__ import annotations

import dataclasses
from dataclasses import replace

import numpy as np

from brdf_suite.acquisition.geometry.lens import Lens
from brdf_suite.acquisition.session.session import (
    Board,
    FlatField,
    Light,
    Position,
    Session,
    SessionCamera,
    Sphere,
    WhiteReference,
)
from brdf_suite.acquisition.simulator.calibration_pictures import TILE_REFLECTANCE
from brdf_suite.acquisition.simulator.curves import response
from brdf_suite.acquisition.simulator.lamp import HOUSING_RADIUS_M, POST_RADIUS_M, profile_table
from brdf_suite.acquisition.simulator.settings import SimulatorSettings
from brdf_suite.arrays import Floats

WHITE_ANGLE_DEG = 30.0
TRUTH_FILE = "truth.json"
_CURVE_POINTS = 257


def nominal_session(
    settings: SimulatorSettings,
    name: str,
    camera: SessionCamera,
    board: tuple[int, int, float, int],
    region: tuple[int, int, int, int],
    irradiance: Floats,
) -> Session:
    """Return the session; ``board`` is columns, rows, side of a square and number of photographs."""
    ending = {"png": ".png", "tiff": ".tif"}[settings.file_kind]
    exposures = settings.exposures_s()

    def series(stem: str, count: int = len(exposures)) -> tuple[str, ...]:
        return tuple(f"{stem}/{k:02d}{ending}" for k in range(count))

    if settings.board:
        columns, rows, square, count = board
        camera = replace(camera, board=Board(columns, rows, square, series("board", count)))
    stated = None if settings.white else tuple(float(v) for v in irradiance)
    light = Light(
        settings.light_distance_m,
        settings.light_height_m,
        None if stated is None else (stated[0], stated[1], stated[2]),
        profile_table() if settings.profile else (),
        housing_radius_m=HOUSING_RADIUS_M if settings.arm else 0.0,
        post_radius_m=POST_RADIUS_M if settings.arm else 0.0,
    )
    white = None
    if settings.white:
        rho = (TILE_REFLECTANCE,) * 3
        white = WhiteReference(series("white"), region, (rho[0], rho[1], rho[2]), WHITE_ANGLE_DEG)
    return Session(
        name,
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


def describe_truth(
    settings: SimulatorSettings,
    name: str,
    lens: Lens,
    irradiance: Floats,
    black: int,
    unit: Floats,
    centres: list[list[float]],
    lamps: list[list[float]],
) -> dict[str, object]:
    """Return the truth as JSON has it.

    ``response`` holds codes and, for each, the exposure of the three channels in the photographs' unit.
    """
    filling = np.linspace(0.0, 1.0, _CURVE_POINTS)
    white = 2**settings.bit_depth - 1
    codes = black + response(settings.curve, filling[:, None]) * (white - black)
    return {
        "paint": name,
        "settings": dataclasses.asdict(settings),
        "intrinsics": dataclasses.asdict(lens),
        "irradiance_rgb": [float(v) for v in irradiance],
        "black_code": black,
        "response": {"codes": codes.T.tolist(), "exposures": (filling[:, None] * unit).T.tolist()},
        "sphere_centres_m": [[float(v) for v in centre] for centre in centres],
        "lamps_m": [[float(v) for v in lamp] for lamp in lamps],
    }
