"""Cook-Torrance and Table 1 against the paper and numbers worked out by hand."""

from __future__ import annotations

import dataclasses
import math
import re
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.documents.cook_torrance import Clearcoat, CookTorranceLobe, CookTorrancePaint
from brdf_suite.geometry import warps
from brdf_suite.geometry.directions import illumination, mirror, spherical
from brdf_suite.reflectance.albedo import directional_albedo
from brdf_suite.reflectance.designed.build import build_reflectance
from brdf_suite.reflectance.models.coated import Coated
from brdf_suite.reflectance.models.cook_torrance import CookTorrance, index_from_reflectance
from brdf_suite.reflectance.models.table_1 import TABLE_1

NORMAL = np.array([0.0, 0.0, 1.0])


def one_lobe(ks: float, m: float, r: float, d_norm: str = "full") -> CookTorrance:
    return CookTorrance(
        CookTorrancePaint("one", (0.0, 0.0, 0.0), (CookTorranceLobe((ks, ks, ks), m, r),), d_norm)
    )


def test_along_the_normal_by_hand() -> None:
    """G = 1, D = 1/m² = 25, F = r: f = 0.1/π + 0.3 · 0.04 · 25/π = 0.4/π; a quarter of the lobe: 0.175/π."""
    paint = CookTorrancePaint("p", (0.1, 0.1, 0.1), (CookTorranceLobe((0.3, 0.3, 0.3), 0.2, 0.04),))
    np.testing.assert_allclose(CookTorrance(paint).eval(NORMAL, NORMAL), 0.4 / math.pi, rtol=1e-12)
    quarter = dataclasses.replace(paint, d_norm="quarter")
    np.testing.assert_allclose(CookTorrance(quarter).eval(NORMAL, NORMAL), 0.175 / math.pi, rtol=1e-12)


def test_at_45_degrees_to_the_normal_by_hand() -> None:
    """Light at 45°, view along the normal, n = 1.5, m = 0.5; each term worked out from its formula.

    θh = 22.5°: tan² = 0.171572875, cos⁴ = 0.728553391; D = e^(-0.686291501)/(0.25 · 0.728553391) = 2.764061;
    G = min(1, 2 cos 22.5° · cos 45°/cos 22.5°) = 1; F at 22.5°: sin θt = 0.382683432/1.5, θt = 14.7803°,
    r_s = -sin(7.7197°)/sin(37.2803°), r_p = tan(7.7197°)/tan(37.2803°): F = (0.2217744² + 0.1780690²)/2.
    """
    inside = math.asin(math.sin(math.radians(22.5)) / 1.5)
    plus, minus = math.radians(22.5) + inside, math.radians(22.5) - inside
    fresnel = 0.5 * ((math.sin(minus) / math.sin(plus)) ** 2 + (math.tan(minus) / math.tan(plus)) ** 2)
    assert fresnel == pytest.approx(0.0404, abs=2e-4)
    facets = math.exp(-0.171572875 / 0.25) / (0.25 * 0.728553391)
    expected = 0.7 * fresnel * facets / (math.pi * math.cos(math.radians(45.0)))
    found = one_lobe(0.7, 0.5, 0.04).eval(illumination(45.0), NORMAL)
    np.testing.assert_allclose(found, expected, rtol=1e-8)


def test_grooves_shade_at_grazing_light_and_view_by_hand() -> None:
    """Mirror pair at 80°: cosθh = 1, wo·h = cos 80°, so G = 2 cos 80°/cos 80° held to 1. With light at 80° and view
    at 80° at right angles to it, h is at θh = atan(sin 80° √2 / (2 cos 80°)), wo·h = √((1 + cos² 80°)/2)."""
    c = math.cos(math.radians(80.0))
    wi, wo = illumination(80.0), spherical(math.radians(80.0), math.radians(90.0))
    cos_d = math.sqrt(0.5 * (1.0 + c * c))
    cos_h = c / cos_d
    grooves = 2.0 * cos_h * c / cos_d
    assert grooves < 0.2
    tan2 = 1.0 / cos_h**2 - 1.0
    expected = grooves * math.exp(-tan2 / 4.0) / (4.0 * cos_h**4) / (math.pi * c * c)
    np.testing.assert_allclose(one_lobe(1.0, 2.0, 1.0).eval(wi, wo), expected, rtol=1e-10)
    at_mirror = one_lobe(1.0, 2.0, 1.0).eval(wi, mirror(wi))
    np.testing.assert_allclose(at_mirror, 1.0 / (4.0 * math.pi * c * c), rtol=1e-10)


@pytest.mark.parametrize(("r", "index"), [(0.0, 1.0), (0.04, 1.5), (0.25, 3.0), (0.9, 37.974)])
def test_the_index_gives_back_the_reflectance(r: float, index: float) -> None:
    assert index_from_reflectance(r) == pytest.approx(index, abs=1e-3)
    n = index_from_reflectance(r)
    assert ((n - 1.0) / (n + 1.0)) ** 2 == pytest.approx(r, abs=1e-12)


def test_full_reflectance_does_not_depend_on_the_angle() -> None:
    """F = 1 for r = 1: at the mirror direction f cos² = 1/(π m²) at every angle where G is 1."""
    for angle in (0.0, 30.0, 60.0, 80.0):
        wi = illumination(angle)
        value = one_lobe(1.0, 0.3, 1.0).eval(wi, mirror(wi)) * wi[2] ** 2
        np.testing.assert_allclose(value, 1.0 / (math.pi * 0.09), rtol=1e-10)


def test_a_quarter_of_ks_is_a_mirror_of_narrow_facets() -> None:
    """Equation 1 has no 4 in its denominator, so ks = 1/4 sends back F whole."""
    albedo = directional_albedo(one_lobe(0.25, 0.01, 1.0), illumination(np.array([0.0, 45.0])))
    np.testing.assert_allclose(albedo, 1.0, atol=2e-3)
    quarter = directional_albedo(one_lobe(1.0, 0.01, 1.0, "quarter"), illumination(np.array([0.0, 45.0])))
    np.testing.assert_allclose(quarter, albedo, rtol=1e-9)


def test_the_numbers_are_the_papers(shared_data: Path) -> None:
    """Table 1 as the paper's text prints it, read here by its own small reader."""
    text = next((shared_data.parent / "seeds").glob("003_*.txt"), None)
    if text is None:
        pytest.skip("the paper's text is not there")
    rows = [
        line.split("\t") for line in text.read_text(encoding="utf-8").splitlines() if line.count("\t") == 4
    ]
    assert len(rows) == 22
    for block in (rows[:11], rows[11:]):
        for column in range(1, 5):
            name = block[0][column].strip()
            paint = next(p for p in TABLE_1.values() if p.name == name)
            cells = [tuple(float(n) for n in re.split(r",\s*", row[column].strip())) for row in block[1:]]
            assert paint.kd == cells[0]
            lobes = [(lobe.ks, (lobe.m,), (lobe.r,)) for lobe in paint.lobes]
            assert [part for lobe in lobes for part in lobe] == cells[1:]
    assert len(TABLE_1) == 8


def test_a_clearcoat_of_the_document_is_laid_over() -> None:
    paint = dataclasses.replace(TABLE_1["table1_blue"], clearcoat=Clearcoat(1.5, 0.01))
    built = build_reflectance(paint)
    assert isinstance(built, Coated)
    wi = illumination(30.0)
    assert np.all(built.eval(wi, mirror(wi)) > build_reflectance(TABLE_1["table1_blue"]).eval(wi, mirror(wi)))


def test_blocks_give_what_single_pairs_give() -> None:
    """Many pairs go in blocks on threads; each pair's value is the same alone."""
    random = np.random.default_rng(5)
    wi, wo = warps.cosine_hemisphere(random.random((2, 40_000, 2)))
    model = CookTorrance(TABLE_1["table1_bmw_339"])
    together = model.eval(wi, wo)
    for index in (0, 16_383, 16_384, 39_999):
        np.testing.assert_allclose(model.eval(wi[index], wo[index]), together[index], rtol=1e-12)


def test_one_paint_of_the_table_makes_light_at_grazing_incidence() -> None:
    """Blue Matte: its second lobe's weight is 1.12 times a mirror's in blue, and F goes to 1. The size is reported."""
    models = {name: CookTorrance(paint) for name, paint in TABLE_1.items()}
    excess = {n: directional_albedo(m, illumination(89.0)).max() - 1.0 for n, m in models.items()}
    assert excess.pop("table1_blue_matte") == pytest.approx(0.099, abs=0.002)
    assert max(excess.values()) < 0.0
    assert not models["table1_blue_matte"].energy_conserving
    assert directional_albedo(models["table1_blue_matte"], illumination(85.0)).max() < 0.82
