"""The cuts' directions against their angles, and their values against ``eval`` and numbers worked out by hand."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.geometry.directions import (
    angle_between,
    aspecular_angle,
    half_angle_coordinates,
    mirror,
    spherical,
)
from brdf_suite.inspection.slices.cuts import (
    HORIZON_DEG,
    difference_slice,
    half_slice,
    light_at,
    plane_slice,
    view_at,
)
from brdf_suite.inspection.slices.values import channel_of, evaluate, radius_of, slice_error
from brdf_suite.reflectance.models.poulin_fournier import PoulinFournier


class Spike:
    """A cosine lobe of exponent 10⁵ about the mirror direction: half of its height is .21° away."""

    def eval(self, wi, wo):
        dot = np.einsum("...i,...i", mirror(wi), wo)
        return np.repeat((np.maximum(dot, 0.0) ** 1e5)[..., None], 3, axis=-1)


class Holed:
    """NaN for views on the light's side, an error of a division elsewhere beneath the horizon."""

    def eval(self, wi, wo):
        value = np.ones((*np.broadcast_shapes(wi.shape, wo.shape)[:-1], 3)) / np.where(
            wo[..., 2:] > 0, 1.0, 0.0
        )
        value[np.broadcast_to(wo[..., 0] < 0.0, value.shape[:-1])] = np.nan
        return value


@pytest.mark.parametrize(("theta", "phi"), [(0.0, 0.0), (45.0, 0.0), (70.0, 130.0), (89.9, -60.0)])
def test_the_plane_of_incidence_has_its_angles(theta: float, phi: float) -> None:
    cut = plane_slice(theta, phi)
    assert (np.diff(cut.angle_deg) > 0.0).all()
    assert abs(cut.angle_deg).max() <= HORIZON_DEG
    assert (cut.wo[:, 2] > 0.0).all()
    assert np.abs(cut.wi - light_at(theta, phi)).max() < 1e-15
    turned = cut.over("gamma", theta)
    assert turned.angle_deg == pytest.approx((theta - cut.angle_deg)[::-1])
    if theta > 0.0:
        assert np.degrees(aspecular_angle(turned.wi, turned.wo)) == pytest.approx(turned.angle_deg, abs=1e-6)
    assert np.degrees(angle_between(mirror(cut.wi), cut.wo)).min() == pytest.approx(0.0, abs=1e-6)


def test_a_spike_is_met_however_sharp() -> None:
    for theta in (0.0, 12.3456, 45.0, 77.7):
        cut = plane_slice(theta, 20.0)
        (value,) = evaluate(Spike(), [cut], cosine="none")
        assert value.max() == pytest.approx(1.0, abs=1e-9)
        # The line follows its flanks: many points stand between a twentieth and nineteen.
        assert ((value[:, 0] > 0.05) & (value[:, 0] < 0.95)).sum() >= 8
    (value,) = evaluate(Spike(), [half_slice(45.0, 90.0, 0.0)], cosine="none")
    assert np.nanmax(value) == pytest.approx(1.0, abs=1e-9)


@pytest.mark.parametrize("phi_d", [0.0, 37.0, 90.0])
def test_half_angle_cuts_have_their_coordinates(phi_d: float) -> None:
    for cut, fixed in ((half_slice(30.0, phi_d, 25.0), 2), (difference_slice(20.0, phi_d, 25.0), 0)):
        inside = cut.above & (cut.angle_deg > 0.0)
        found = np.degrees(half_angle_coordinates(cut.wi[inside], cut.wo[inside]))
        assert found[2 - fixed] == pytest.approx(cut.angle_deg[inside], abs=1e-6)
        assert found[fixed] == pytest.approx({2: 30.0, 0: 20.0}[fixed], abs=1e-6)
        assert found[3] == pytest.approx(phi_d, abs=1e-4)
        assert found[1] == pytest.approx(25.0, abs=1e-4)
        beneath = ~cut.above
        assert (np.minimum(cut.wi[beneath, 2], cut.wo[beneath, 2]) < 0.002).all()


def test_values_are_those_of_eval_with_and_without_the_cosine() -> None:
    class Model:
        calls = 0

        def eval(self, wi, wo):
            self.calls += 1
            return np.stack((wi[..., 2] * wo[..., 2], wo[..., 0] ** 2, wi[..., 1] ** 2), axis=-1)

    model, cuts = (
        Model(),
        [plane_slice(40.0, 70.0), half_slice(40.0, 90.0, 70.0), difference_slice(0.0, 90.0, 0.0)],
    )
    plain, lit = evaluate(model, cuts, cosine="none"), evaluate(model, cuts, cosine="light")
    assert model.calls == 2  # once for all cuts
    for cut, value, with_cosine in zip(cuts, plain, lit, strict=True):
        wanted = np.where(cut.above[:, None], Model().eval(cut.wi, cut.wo), np.nan)
        assert np.array_equal(value, wanted, equal_nan=True)
        assert np.allclose(with_cosine, wanted * cut.wi[:, 2:], rtol=1e-14, equal_nan=True)


def test_holes_of_nan_are_gaps_and_no_warning() -> None:
    cut = plane_slice(30.0, 0.0)
    (value,) = evaluate(Holed(), [cut], cosine="light")
    assert np.isnan(value[cut.angle_deg < 0.0]).all()
    assert np.isfinite(value[cut.angle_deg > 0.0]).all()
    assert slice_error(cut.angle_deg, value[:, 0], 0.0 * value[:, 0] + 1.0) is not None
    assert slice_error(cut.angle_deg, np.full(len(value), np.nan), value[:, 0]) is None
    assert evaluate(Holed(), [], cosine="light") == []


def test_anisotropy_shows_in_the_azimuth_of_the_incidence() -> None:
    model = PoulinFournier(kd=0.0, exponent=200.0)
    along, across = (evaluate(model, [plane_slice(30.0, phi)], cosine="none")[0] for phi in (0.0, 90.0))
    away = np.abs(plane_slice(30.0, 0.0).angle_deg + 30.0).argmin()
    # The cylinders lie along x: across them they send light to either side, along them they do not.
    assert across[away, 0] > 100.0 * along[away, 0]


def test_channels_and_radii() -> None:
    value = np.array([[1.0, 2.0, 4.0], [np.nan, np.nan, np.nan]])
    assert channel_of(value, "g")[0] == 2.0
    assert channel_of(np.ones((2, 3)), "luminance") == pytest.approx(1.0)
    assert np.array_equal(channel_of(value, "colour"), channel_of(value, "luminance"), equal_nan=True)
    share = np.array([0.0, 1e-9, 1e-5, 1e-3, 0.125, 1.0, -1.0])
    assert radius_of(2.0 * share, "linear", 2.0)[-3:] == pytest.approx([0.125, 1.0, 0.0])
    assert radius_of(2.0 * share, "cbrt", 2.0)[-3:] == pytest.approx([0.5, 1.0, 0.0])
    assert radius_of(2.0 * share, "log", 2.0) == pytest.approx(
        [0, 0, 1 / 6, 0.5, 1 + np.log10(0.125) / 6, 1, 0]
    )
    assert np.isnan(radius_of(np.array([np.nan]), "log", 1.0)).all()


def test_the_error_counts_angles_and_not_points() -> None:
    angle = np.concatenate(
        (np.linspace(-90.0, -0.1, 50), np.linspace(0.0, 1e-3, 1000), np.linspace(0.1, 90.0, 50))
    )
    target = np.ones_like(angle)
    fit = np.where(angle > 0.05, 1.5, 1.0)
    error = slice_error(angle, target, fit)
    assert error.rms == pytest.approx(0.5 * np.sqrt(0.5), rel=1e-2)
    assert error.relative == pytest.approx(error.rms)
    assert error.worst == 0.5
    assert error.worst_deg >= 0.1
    zero = slice_error(angle, 0.0 * angle, 0.0 * angle)
    assert (zero.rms, zero.relative) == (0.0, 0.0)


def test_view_and_light_share_the_plane() -> None:
    assert np.allclose(view_at(45.0, 30.0), mirror(light_at(45.0, 30.0)))
    assert np.allclose(view_at(-45.0, 30.0), light_at(45.0, 30.0))
    assert np.allclose(spherical(np.radians(45.0), np.radians(210.0)), light_at(45.0, 30.0))
