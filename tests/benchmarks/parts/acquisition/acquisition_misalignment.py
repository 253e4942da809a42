"""A simulated rig whose lamp and sphere are not where the session says: what refinement makes of it.

Called by bench_acquisition.py. The same photographs are reconstructed with and without refinement; the error is the
median over the table's measured bins with θi and θo below 75°, the channels' mean against the paint.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.acquisition.geometry.lens import lens_pixels
from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry, unit
from brdf_suite.acquisition.reconstruction.options import AcquireOptions
from brdf_suite.acquisition.reconstruction.reconstruction import Acquisition
from brdf_suite.acquisition.reconstruction.table import reconstruct
from brdf_suite.acquisition.simulator import Simulator, SimulatorSettings
from brdf_suite.progress import Progress, subrange
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from tools.evaluation.simulated_source import SimulatorSource

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "misaligned_ratio": (
        "<=",
        1.5,
        "",
        "lamp 0.5° and sphere 2 pixels off: median table error after refinement, relative to an aligned rig",
    ),
    "unrefined_ratio": ("<=", None, "", "the same without refinement"),
    "misaligned_centre_px": ("<=", None, "pixels", "error of the sphere's centre after refinement"),
    "misaligned_light_deg": (
        "<=",
        None,
        "°",
        "largest error of lamp directions after refinement, all angles",
    ),
    "highlight_rms_px": ("<=", None, "pixels", "highlight residuals after refinement, root mean square"),
}
NOTES: dict[str, str] = {}

PAINT = "table1_polaris_silver"
SIZE = (320, 320)
POSITIONS = 60
LIMIT_DEG = 75.0
LAMP_DEG, CENTRE_PX = 0.5, (2.0, 0.0)


def rig(*, misaligned: bool) -> Simulator:
    """Return the simulated rig, aligned or not; nothing else differs between them."""
    settings = SimulatorSettings(
        size=SIZE,
        positions=POSITIONS,
        light_offset_deg=LAMP_DEG if misaligned else 0.0,
        centre_offset_px=CENTRE_PX if misaligned else (0.0, 0.0),
    )
    return Simulator(CookTorrance(TABLE_1[PAINT]), settings, PAINT)


def median_error(table: IsotropicTable, simulator: Simulator) -> float:
    """Return the median relative error over measured bins whose directions are within the limit."""
    grid = HalfAngleGrid(*table.values.shape[:3], reciprocal=table.reciprocal)
    least = np.cos(np.radians(LIMIT_DEG))
    errors = []
    for h in range(grid.theta_h):
        wi, wo = grid.pairs(h)
        kept = (wi[..., 2] > least) & (wo[..., 2] > least) & ~table.holes[h]
        truth = simulator.reflectance.eval(wi[kept], wo[kept]).mean(axis=-1)
        errors.append(np.abs(table.values[h][kept].mean(axis=-1) / truth - 1.0))
    return float(np.median(np.concatenate(errors)))


def centre_and_light(geometry: RigGeometry, simulator: Simulator) -> tuple[float, float]:
    """Return by how much the sphere's centre is off in the picture, pixels, and the lamp at most, degrees.

    The lamp's direction is taken at the sphere, against that to the camera: a lens whose middle is not well known
    turns the camera's frame, and changes neither.
    """
    distance = simulator.settings.camera_distance_m

    def in_camera(places: object) -> np.ndarray:
        # The camera of this rig is level: x is the same, y is turned down, z away from it.
        return np.array(places) * (1.0, -1.0, -1.0) + (0.0, 0.0, distance)

    angles = simulator.settings.angles()
    centre = in_camera(simulator.truth["sphere_centres_m"])[0]
    lamps = in_camera([simulator.lamp(k).place for k in range(len(angles))])
    true = simulator.optics.lens
    across = np.linalg.norm(lens_pixels(geometry.lens, geometry.centre) - lens_pixels(true, centre))
    off = _as_seen(geometry.light(angles), geometry.centre) - _as_seen(lamps, centre)
    return float(across), float(np.degrees(np.linalg.norm(off, axis=-1).max()))


def _as_seen(lamps: np.ndarray, centre: np.ndarray) -> np.ndarray:
    """Return the directions from the sphere to lamps (n, 3) in a frame whose z points to the camera, y upward."""
    front = unit(-centre)
    side = unit(np.cross((0.0, -1.0, 0.0), front))
    return unit(lamps - centre) @ np.stack((side, np.cross(front, side), front)).T


def figures(progress: Progress | None = None) -> dict[str, float]:
    """Reconstruct the aligned rig, and the one out of line with and without refinement."""
    found: dict[str, float] = {}
    errors = {}
    for number, (name, misaligned, refine) in enumerate(
        (("aligned", False, True), ("misaligned", True, True), ("unrefined", True, False))
    ):
        simulator = rig(misaligned=misaligned)
        road = Acquisition(SimulatorSource(simulator), AcquireOptions(refine=refine))
        road.calibrate(subrange(progress, number / 3.0, (number + 0.3) / 3.0))
        table = reconstruct(road, subrange(progress, (number + 0.3) / 3.0, (number + 1) / 3.0)).table
        errors[name] = median_error(table, simulator)
        if name == "misaligned":
            assert road.geometry is not None
            assert road.refinement is not None
            found["misaligned_centre_px"], found["misaligned_light_deg"] = centre_and_light(
                road.geometry, simulator
            )
            found["highlight_rms_px"] = road.refinement.rms_px
    found["misaligned_ratio"] = errors["misaligned"] / errors["aligned"]
    found["unrefined_ratio"] = errors["unrefined"] / errors["aligned"]
    NOTES["misaligned_ratio"] = (
        f"median errors {errors['aligned']:.4f} aligned, {errors['misaligned']:.4f} refined, "
        f"{errors['unrefined']:.4f} unrefined; {POSITIONS} positions of {SIZE[0]} × {SIZE[1]} pixels"
    )
    return found
