"""The instrument's cones against closed forms, and a paint solved through them."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
import pytest

from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.appearance.geometries import measured_set
from brdf_suite.documents.paint import Gloss, Measurement, Paint
from brdf_suite.errors import UnreachableError, ValueRangeError
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.geometry.fresnel import fresnel_at
from brdf_suite.pipeline.material import load_shipped_paint, paint_names
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.instruments.aperture import (
    APERTURES,
    NARROW,
    POINT,
    WIDE,
    Aperture,
    aperture,
    cone,
    reflectance_factor,
)
from brdf_suite.reflectance.instruments.spectrophotometer import measure
from brdf_suite.reflectance.instruments.through_aperture import TOLERANCE_DELTA_E, build_through


@dataclass(frozen=True)
class Power:
    """f_r = cosθi^light · cosθo^view in every channel."""

    light: float
    view: float

    def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        value = np.asarray(wi)[..., 2] ** self.light * np.asarray(wo)[..., 2] ** self.view
        return np.repeat(value[..., None], 3, axis=-1)


def test_cones_have_their_angle_and_even_weights() -> None:
    axis = aspecular_view(45.0, 110.0)
    for rings in (2, 4, 8):
        directions, weights = cone(axis, 4.0, rings)
        assert weights.sum() == pytest.approx(1.0)
        np.testing.assert_allclose(np.linalg.norm(directions, axis=-1), 1.0, atol=1e-12)
        angles = np.degrees(np.arccos(np.clip(directions @ axis, -1, 1)))
        assert 2.8 < angles.max() < 4.0
        # The mean direction of a cone of half-angle α is its axis times (1 + cos α)/2.
        np.testing.assert_allclose(
            weights @ directions, axis * 0.5 * (1 + math.cos(math.radians(4.0))), atol=1e-12
        )


def test_closed_forms() -> None:
    """∫cosθ dω over a cone of half-angle α about a tilted axis is π sin²α cosθ; its solid angle 2π (1 - cosα)."""
    wi, wo = illumination(45.0), aspecular_view(45.0, -15.0)
    c = math.cos(math.radians(4.0))
    rho, change = reflectance_factor(Power(0.0, -1.0), wi, wo, WIDE)
    expected = math.pi * 2.0 * (1.0 - c) / ((1.0 - c * c) * math.cos(math.radians(60.0)))
    np.testing.assert_allclose(rho, expected, rtol=1e-9)
    assert change < 1e-4
    # Straight down, ∫cos²/∫cos is ⅔ (1 - c³)/(1 - c²), for the light's cone and for the receptor's.
    down = np.array([0.0, 0.0, 1.0])
    c_light = math.cos(math.radians(2.0))
    means = [2.0 / 3.0 * (1.0 - k**3) / (1.0 - k**2) for k in (c_light, c)]
    np.testing.assert_allclose(
        reflectance_factor(Power(1.0, 1.0), down, down, WIDE)[0], math.pi * means[0] * means[1], rtol=1e-9
    )
    np.testing.assert_allclose(reflectance_factor(Power(0, 1), wi, down, POINT)[0], math.pi)


def test_a_mirror_inside_the_receptor_sends_all_its_light_there() -> None:
    """A coat narrow against the receptor: ρ = π F / ∫cosθo dω = F / (sin²α cos 45°)."""
    f = fresnel_at(45.0, 1.5)
    rho, change = reflectance_factor(CoatLobe(1.5, 0.01), illumination(45.0), aspecular_view(45.0, 0.0), WIDE)
    expected = f / (math.sin(math.radians(4.0)) ** 2 * math.cos(math.radians(45.0)))
    np.testing.assert_allclose(rho, expected, rtol=5e-3)
    assert change < 5e-3
    # A lobe a fifth as wide is met to a tenth only, and the second number says so.
    rho, change = reflectance_factor(
        CoatLobe(1.5, 0.002), illumination(45.0), aspecular_view(45.0, 0.0), WIDE
    )
    np.testing.assert_allclose(rho, expected, rtol=0.15)
    assert change > 0.05


def test_a_diffuser_reads_one_through_any_aperture() -> None:
    for through in APERTURES.values():
        rho, _change = reflectance_factor(
            Power(0.0, 0.0), illumination(80.0), aspecular_view(45.0, 130.0), through
        )
        np.testing.assert_allclose(rho, math.pi, rtol=1e-12)


def test_an_aperture_changes_a_steep_paint() -> None:
    reflectance = build_paint(load_shipped_paint("fine_silver"))
    single = measure(reflectance, measured_set([(45.0, 15.0)])).lab
    wide = measure(reflectance, measured_set([(45.0, 15.0)]), WIDE).lab
    assert 0.1 < float(delta_e_2000(single, wide)[0]) < 5.0


@pytest.mark.parametrize("through", [POINT, NARROW, WIDE], ids=lambda a: a.name)
@pytest.mark.parametrize("name", paint_names())
def test_a_shipped_paint_reads_its_own_colours(name: str, through: Aperture) -> None:
    paint = load_shipped_paint(name)
    solved = build_through(paint, through)
    angles = measured_set([(m.illumination_deg, m.aspecular_deg) for m in paint.measurements])
    read = measure(solved.reflectance, angles, through).lab
    asked = np.array([m.lab for m in paint.measurements])
    assert float(delta_e_2000(asked, read).max()) <= TOLERANCE_DELTA_E
    if through is POINT:
        assert solved.turns == 1
        assert solved.paint == paint


def test_six_angles_under_any_rule_read_their_colours() -> None:
    labs = [(90.0, 2.0, 20.0), (80.0, 2.0, 18.0), (45.0, 2.0, 14.0), (30.0, 1.5, 11.0), (22.0, 1.0, 9.0)]
    for rule in ("monotone", "polynomial"):
        paint = Paint(
            "gold",
            tuple(
                Measurement(45.0, a, lab)
                for a, lab in zip((15.0, 25.0, 45.0, 75.0, 110.0), labs, strict=True)
            ),
            Gloss(90.0),
            interpolation=rule,
        )
        if rule == "polynomial":
            paint = replace(paint, measurements=(paint.measurements[0], *paint.measurements[2::2]))
        solved = build_through(paint, WIDE)
        assert max(solved.delta_e) <= TOLERANCE_DELTA_E


def test_a_rule_with_fewer_numbers_than_readings_says_what_it_misses() -> None:
    """One bell of flakes cannot pass through six readings, with an aperture or without."""
    labs = (124.0, 128.0, 95.0, 62.0, 38.0, 36.0)
    paint = replace(
        load_shipped_paint("fine_silver"),
        measurements=tuple(
            Measurement(45.0, angle, (lightness, -0.8, -0.5))
            for angle, lightness in zip((-15.0, 15.0, 25.0, 45.0, 75.0, 110.0), labs, strict=True)
        ),
    )
    solved = build_through(paint, WIDE)
    read = measure(
        build_paint(paint), measured_set([(45.0, m.aspecular_deg) for m in paint.measurements])
    ).lab
    np.testing.assert_allclose(
        solved.missed, delta_e_2000(read, [m.lab for m in paint.measurements]), atol=1e-9
    )
    assert max(solved.missed) > TOLERANCE_DELTA_E
    assert max(solved.delta_e) <= max(solved.missed)
    assert any("does not pass through every reading" in notice for notice in solved.notices)


def test_several_lights_are_solved_together() -> None:
    paint = load_shipped_paint("violet_shift")
    second = tuple(
        Measurement(15.0, angle, lab)
        for angle, lab in (
            (15.0, (64.0, -2.0, -44.0)),
            (45.0, (24.0, 26.0, -30.0)),
            (90.0, (10.0, 18.0, -9.0)),
        )
    )
    solved = build_through(replace(paint, measurements=paint.measurements + second), WIDE)
    assert max(solved.missed) < 1e-6
    assert max(solved.delta_e) <= TOLERANCE_DELTA_E


def test_what_cannot_be_solved_is_refused() -> None:
    """At 15° a receptor of 10° and a light of 5° catch the coat's mirror lobe: brighter than this black."""
    with pytest.raises(UnreachableError, match=r"receptor 10°.*at 15° to better than ΔE00"):
        build_through(load_shipped_paint("solid_black"), Aperture("huge", 5.0, 10.0))


def test_apertures_by_name_and_number() -> None:
    assert aperture("wide") is WIDE
    assert aperture("3").receptor_deg == 3.0
    assert (aperture("1,2.5").light_deg, aperture("1,2.5").receptor_deg) == (1.0, 2.5)
    for text, words in (
        ("huge", "point, narrow, wide"),
        ("1,2,3", "neither"),
        ("25", "0 to 20"),
        ("nan", "0 to 20"),
    ):
        with pytest.raises(ValueRangeError, match=words):
            aperture(text)
