"""The table of look-ups: exact where it must be, energy kept, and what is packaged is what the command makes."""

from __future__ import annotations

import json

import numpy as np
import pytest

from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.lighting.filter.shading_table import COAT_IOR, EXPONENTS, LeastSquares, lobe_row
from brdf_suite.resources import resource

ROOTS = np.linspace(0.0, 1.0, 33)


@pytest.fixture(scope="module")
def packaged():
    return json.loads(resource("shading", "look_ups.json").read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def search():
    return LeastSquares()


def test_a_lobe_about_the_normal_is_the_next_exponent(packaged):
    for e, row in zip(packaged["exponents"], packaged["targets"]["plain"], strict=True):
        assert row["exponent"][-1] == pytest.approx(e + 1, rel=2e-4)
        assert row["amplitude"][-1] == pytest.approx(2 * np.pi / (e + 2), rel=1e-4)
    for e, row in zip(packaged["exponents"], packaged["targets"]["gloss"], strict=True):
        assert row["exponent"][-1] == pytest.approx(e, rel=2e-4)


@pytest.mark.parametrize("target", ["plain", "coated", "gloss"])
@pytest.mark.parametrize("index", [0, 5, 12])
@pytest.mark.parametrize("node", [4, 16, 30])
def test_amplitudes_are_integrals(packaged, target, index, node):
    """Against a midpoint rule in polar coordinates about the normal."""
    e, c = packaged["exponents"][index], packaged["cosines"][node]
    theta = (np.arange(1200) + 0.5) * np.pi / 2400
    phi = (np.arange(1200) + 0.5) * np.pi / 1200
    mu = np.cos(theta)[:, None]
    lobe = np.maximum(mu * c + np.sin(theta)[:, None] * np.cos(phi) * np.sqrt(1 - c * c), 0) ** e
    if target != "gloss":
        lobe = lobe * mu
    if target == "coated":
        lobe = (
            lobe
            * (1 - fresnel_dielectric(mu, COAT_IOR))
            / (1 - fresnel_dielectric(np.cos(np.pi / 4), COAT_IOR))
        )
    integral = (lobe * np.sin(theta)[:, None]).sum() * (np.pi / 2400) * (np.pi / 1200) * 2
    assert packaged["targets"][target][index]["amplitude"][node] == pytest.approx(integral, rel=2e-3)


def test_the_packaged_rows_are_what_the_search_finds(packaged, search):
    cosines = np.asarray(packaged["cosines"])
    assert packaged["exponents"] == list(EXPONENTS)
    for target, index in (("plain", 4), ("coated", 9)):
        row = lobe_row(search, target, EXPONENTS[index], cosines)
        for key in ("toward_normal", "exponent", "amplitude"):
            np.testing.assert_allclose(
                row[key], packaged["targets"][target][index][key], rtol=1e-3, atol=1e-4
            )


def test_the_look_up_beats_both_simpler_ones(search):
    """What is left of the expected square of the error, against the paper's direction and the shifted E + 1."""
    for e, c in ((3.0, 0.2), (8.0, 0.4), (20.0, 0.1)):
        values = search.values("plain", e, c)
        gain, _ = search.gain(values)

        def left(angle, exponent, gain=gain):
            nearest = int(np.argmin(np.abs(search.angles - angle)))
            return -gain[nearest, int(np.argmin(np.abs(search.exponents - exponent)))]

        sine = np.sqrt(1 - c * c)
        shifted = left(np.arctan2(e * sine, e * c + 1), e + 1)
        assert -gain.max() < shifted < left(np.arccos(c), e)
