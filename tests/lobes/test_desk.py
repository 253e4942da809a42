"""The desk of Lobe Visualizer: subjects, which of them are seen, the light, the options."""

from __future__ import annotations

import numpy as np
import pytest
from brdf_lobe_visualizer.desk import Desk
from brdf_lobe_visualizer.options import INCIDENCE_DEG, Options
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial

from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.pipeline.lobe_fit import LobeFit
from brdf_suite.pipeline.material import Material
from brdf_suite.reflectance.models.lambertian import Lambertian


class Unheard:
    def show_message(self, message):
        raise AssertionError(message)

    def dismiss_message(self, key):
        raise AssertionError(key)


@pytest.fixture
def desk(qapp):
    desk = Desk(Unheard())
    yield desk
    assert desk.tasks.stop()


def subject(key: str, **fields) -> PlottedMaterial:
    return PlottedMaterial(key, key.upper(), Material(key.upper(), Lambertian((0.5, 0.5, 0.5))), **fields)


def keys(subjects) -> list[str]:
    return [item.key for item in subjects]


def test_the_first_subject_is_in_front_and_a_removed_one_leaves_its_neighbour_there(desk) -> None:
    assert desk.front is None
    for key in "abc":
        desk.add(subject(key))
    assert desk.front.key == "a"
    desk.set_front("b")
    desk.remove("b")
    assert desk.front.key == "c"
    desk.remove("c")
    desk.remove("a")
    assert desk.front is None
    assert desk.visible == ()


def test_hidden_ones_are_not_visible_and_solo_ones_alone_are(desk) -> None:
    for key in "abc":
        desk.add(subject(key))
    heard = []
    desk.visibility_changed.connect(lambda: heard.append(keys(desk.visible)))
    desk.set_hidden("b", True)
    desk.set_solo("b", True)
    desk.set_solo("b", False)
    desk.show_all()
    assert heard == [["a", "c"], ["b"], ["a", "c"], ["a", "b", "c"]]


def test_a_reference_that_is_removed_is_none_any_more(desk) -> None:
    desk.add(subject("a"))
    desk.add(subject("b"))
    desk.set_compared("b")
    heard = []
    desk.visibility_changed.connect(lambda: heard.append(desk.compared))
    desk.remove("b")
    assert heard == [None]
    desk.set_compared("no such")
    assert desk.compared is None


def test_moving_and_changing_keep_key_and_front(desk) -> None:
    for key in "abc":
        desk.add(subject(key))
    desk.move("a", 5)
    assert keys(desk.subjects) == ["b", "c", "a"]
    desk.change("a", title="Other")
    assert (desk.front.key, desk.front.title) == ("a", "Other")
    desk.change("gone", title="Nothing happens")
    assert keys(desk.subjects) == ["b", "c", "a"]


@pytest.mark.parametrize(
    ("asked", "kept"),
    [
        ((30.0, 370.0), (30.0, 10.0)),
        ((-5.0, -180.0), (0.0, 180.0)),
        ((120.0, 540.0), (89.9, 180.0)),
        ((12.5, -90.0), (12.5, -90.0)),
    ],
)
def test_an_incidence_is_brought_into_its_range(desk, asked, kept) -> None:
    desk.set_incidence(*asked)
    assert desk.incidence == pytest.approx(kept)


def test_the_light_stands_opposite_the_azimuth_and_is_told_once(desk) -> None:
    heard = []
    desk.incidence_changed.connect(lambda theta, phi: heard.append((theta, phi)))
    desk.set_incidence(60.0, 90.0)
    desk.set_incidence(60.0, 90.0)
    np.testing.assert_allclose(desk.light, [0.0, -np.sqrt(0.75), 0.5], atol=1e-12)
    desk.reset_incidence()
    assert heard == [(60.0, 90.0), INCIDENCE_DEG]


def test_every_option_goes_back(desk) -> None:
    desk.set_options(channel="r", radius="log", cosine="none", shown="both")
    desk.reset_options("radius")
    assert desk.options == Options(channel="r", cosine="none", shown="both")
    desk.reset_options()
    assert desk.options == Options()


def test_a_lobe_that_is_switched_off_weighs_nothing_and_comes_back(desk) -> None:
    weights = LobeWeights(
        np.array([5.0, 50.0]), np.ones(3), np.full((2, 3), 2.0), np.full((2, 3), 3.0), 0.7, 1.5
    )
    one = subject("a", fit=LobeFit(Material("fit", weights), "measured", weights, {}, (), 0.001))
    assert desk.weights_of(subject("b")) is None
    assert desk.weights_of(one) is weights
    desk.switch_lobe("gloss", 1, False)
    desk.switch_lobe("diffuse", 0, False)
    desk.switch_lobe("directional", 9, False)  # of a fit with more lobes
    left = desk.weights_of(one)
    np.testing.assert_array_equal(left.kg[:, 0], [3.0, 0.0])
    np.testing.assert_array_equal(left.kd, np.zeros(3))
    np.testing.assert_array_equal(left.kdd, weights.kdd)
    desk.switch_lobe("diffuse", 0, True)
    np.testing.assert_array_equal(desk.weights_of(one).kd, weights.kd)
