"""Skies: the published models against another implementation, and the sun's disc."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.documents.studio import Sky
from brdf_suite.lighting.procedural import sky
from brdf_suite.lighting.procedural.daylight import overcast_sky
from brdf_suite.lighting.procedural.hosek_wilkie import (
    WAVELENGTHS_NM,
    HosekWilkieSky,
    _tables,
    spectrum_to_working,
    sun_spectral,
)
from brdf_suite.lighting.procedural.panorama import centres, directions, horizontal_illuminance, solid_angles
from brdf_suite.lighting.procedural.sky import build_sky
from brdf_suite.lighting.procedural.sun import DIAMETER_DEG, LimbDisc, Sun


def dome(count: int, seed: int = 3) -> np.ndarray:
    toward = np.random.default_rng(seed).normal(size=(count, 3))
    toward[:, 1] = np.abs(toward[:, 1])
    return toward / np.linalg.norm(toward, axis=1, keepdims=True)


class Theirs:
    """Mitsuba's emitter, z up; radiance at four wavelengths at a time."""

    def __init__(self, turbidity: float, albedo: float, sun: np.ndarray, **more: float) -> None:
        self.mi = pytest.importorskip("mitsuba")
        self.mi.set_variant("scalar_spectral")
        ground = {"type": "uniform", "value": albedo}
        self.emitter = self.mi.load_dict(
            {
                "type": "sunsky",
                "turbidity": turbidity,
                "albedo": ground,
                "sun_direction": self.turned(sun),
                **more,
            }
        )
        self.at = self.mi.SurfaceInteraction3f()

    @staticmethod
    def turned(v: np.ndarray) -> list[float]:
        return [float(v[2]), float(v[0]), float(v[1])]

    def __call__(self, toward: np.ndarray, wavelengths: list[float]) -> np.ndarray:
        found = []
        for one in toward:
            self.at.wi = self.mi.Vector3f(*self.turned(-one))
            self.at.wavelengths = wavelengths
            found.append(np.array(self.emitter.eval(self.at)))
        return np.array(found)


@pytest.mark.parametrize(
    ("turbidity", "albedo", "elevation"),
    [(2.0, 0.0, 10.0), (3.3, 0.3, 40.0), (7.7, 0.8, 75.0), (10.0, 1.0, 3.0), (1.7, 0.5, 89.0)],
)
def test_the_sky_is_that_of_mitsuba(turbidity: float, albedo: float, elevation: float) -> None:
    sun = Sun(elevation, 62.0).direction
    toward = dome(60)
    theirs = Theirs(turbidity, albedo, sun, sun_scale=0.0)
    own = HosekWilkieSky(sun, turbidity, albedo).spectral(toward)
    for first in (0, 4):
        truth = theirs(toward, [float(w) for w in WAVELENGTHS_NM[first : first + 4]])
        np.testing.assert_allclose(own[:, first : first + 4], truth, rtol=3e-5)


@pytest.mark.parametrize("turbidity", [2.0, 4.5, 9.0])
def test_the_sun_is_that_of_mitsuba(turbidity: float) -> None:
    """Theirs is the mean over the disc, interpolated between elevations; ours goes on to the limb and on the curve."""
    sun = Sun(50.0, -20.0)
    theirs = Theirs(turbidity, 0.2, sun.direction, sky_scale=0.0, sun_aperture=DIAMETER_DEG)
    truth = theirs(sun.direction[None], [400.0, 480.0, 560.0, 640.0])[0]
    cos_psi = np.sqrt((np.arange(400) + 0.5) / 400)  # evenly over the disc's area
    own = sun_spectral(np.radians(50.0), turbidity, DIAMETER_DEG, cos_psi).mean(axis=0)[[2, 4, 6, 8]]
    np.testing.assert_allclose(own, truth, rtol=1e-2)


def test_the_tables_are_the_authors(checkout: Path) -> None:
    pytest.importorskip("mitsuba")
    spec = importlib.util.spec_from_file_location(
        "generate_sky_tables", checkout / "packaging" / "generators" / "sky_tables.py"
    )
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    origin = importlib.util.find_spec("mitsuba")
    assert origin is not None
    assert origin.origin is not None
    truth = module.read_tensors(Path(origin.origin).parent / "data" / "sunsky" / "sunsky_datasets.bin")
    for name, shape in module.FIELDS.items():
        np.testing.assert_array_equal(_tables()[name], truth[name].astype(np.float32).reshape(shape))


def test_equal_energy_is_whiteish_and_555_nm_is_683_lumens() -> None:
    flat = np.full(11, 1e-3) @ spectrum_to_working()
    # ∫ȳ = 106.86 nm for the 2° observer.
    assert flat @ LUMINANCE == pytest.approx(683.002 * 106.856 * 1e-6, rel=1e-3)
    assert np.ptp(flat) / flat.mean() < 0.25


def test_luminances_are_those_of_the_world() -> None:
    """Bright day: some 3 kcd/m² at the zenith, 70 to 110 klx on the ground; haze takes from the sun."""
    zenith = build_sky(Sky("a"))(np.array([[0.0, 1.0, 0.0]]))[0] @ LUMINANCE
    assert 2.0 < zenith < 6.0
    high = Sky("b", sun_elevation_deg=60.0)
    made = sky(high, height=128, samples=1)
    assert made.white_luminance is not None
    assert 80.0 < made.white_luminance * np.pi / 1000.0 < 120.0
    clear, hazy = (LimbDisc(Sun(30.0, 0.0), t).illuminance() @ LUMINANCE for t in (2.0, 6.0))
    assert 60.0 < hazy + 10.0 < clear < 95.0
    low = LimbDisc(Sun(4.0, 0.0), 3.0).illuminance()
    assert low[0] > low[1] > low[2], "a low sun is red"


@settings(max_examples=settings.default.max_examples // 4)
@given(st.floats(1.0, 89.9), st.floats(-180.0, 180.0), st.sampled_from([32, 64, 256]))
def test_the_disc_gives_the_same_light_on_every_map(elevation: float, azimuth: float, rows: int) -> None:
    disc = LimbDisc(Sun(elevation, azimuth), 3.0)
    picture = disc.add_to(np.zeros((rows, 2 * rows, 3)))
    light = (picture * solid_angles(rows)[..., None]).sum(axis=(0, 1))
    np.testing.assert_allclose(light, disc.illuminance(), rtol=1e-9)
    toward = directions(centres(rows), centres(2 * rows))
    middle = (toward * (picture @ LUMINANCE * solid_angles(rows))[..., None]).sum(axis=(0, 1))
    apart = np.degrees(np.arccos(min(1.0, float(middle / np.linalg.norm(middle) @ disc.sun.direction))))
    assert apart < 0.75 * 180.0 / rows


def test_the_disc_has_its_size_and_darkens_towards_its_limb() -> None:
    disc = LimbDisc(Sun(20.0, 10.0), 2.5)
    rows = 1024
    picture = disc.add_to(np.full((rows, 2 * rows, 3), -1.0))[:, :, 0]
    # What is covered, over the whole disc: the background of -1 is left by the share that the disc leaves.
    lit = np.argwhere(picture > 0.0)
    assert 2 <= np.ptp(lit[:, 0]) + 1 <= 5, "0.53° is three rows of 0.18°"
    assert len(lit) <= 30
    middle, limb = disc.radiance(np.array([0.0, 0.98]))
    assert limb @ LUMINANCE < 0.6 * (middle @ LUMINANCE)
    assert limb[2] / middle[2] < limb[0] / middle[0], "redder at the limb"


@pytest.mark.parametrize("model", ["hosek_wilkie", "preetham", "overcast"])
def test_a_sky_is_drawn_with_its_ground(model: str) -> None:
    without, bright = (
        sky(Sky("s", model, ground_albedo=a, sun_disc=False), height=64, samples=1).radiance  # type: ignore[arg-type]
        for a in (0.0, 0.5)
    )
    assert without[34:].max() == 0.0
    assert np.isfinite(bright).all()
    assert bright[:30].min() > 0.0
    assert horizontal_illuminance(bright) == pytest.approx(np.pi, rel=1e-3)
    ground = bright[40, 0] @ LUMINANCE
    if model == "overcast":
        assert ground == pytest.approx(0.5, rel=2e-2), "albedo times a white card"
    else:
        assert ground > 0.8, "the sun lights the ground though its disc is not drawn"


def test_the_ground_brightens_the_hosek_wilkie_sky() -> None:
    toward = dome(50)
    dark, snow = (build_sky(Sky("s", ground_albedo=a))(toward) @ LUMINANCE for a in (0.0, 1.0))
    assert (snow > dark).all()


def test_the_overcast_sky_is_the_standard_one_under_every_haze() -> None:
    toward = dome(50)
    np.testing.assert_array_equal(build_sky(Sky("s", "overcast", 9.0))(toward), overcast_sky(toward))
