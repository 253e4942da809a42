"""The session of Lobe Visualizer: subjects, which of them are seen, the light, the options."""

from __future__ import annotations

import numpy as np
import pytest
from brdf_lobe_visualizer.options import INCIDENCE_DEG, Options
from brdf_lobe_visualizer.session import LobeSession
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
def session(qapp):
    session = LobeSession(Unheard())
    yield session
    assert session.tasks.stop()


def subject(key: str, **fields) -> PlottedMaterial:
    return PlottedMaterial(key, key.upper(), Material(key.upper(), Lambertian((0.5, 0.5, 0.5))), **fields)


def keys(subjects) -> list[str]:
    return [item.key for item in subjects]


def test_the_first_subject_is_in_front_and_a_removed_one_leaves_its_neighbour_there(session) -> None:
    assert session.front is None
    for key in "abc":
        session.add(subject(key))
    assert session.front.key == "a"
    session.set_front("b")
    session.remove("b")
    assert session.front.key == "c"
    session.remove("c")
    session.remove("a")
    assert session.front is None
    assert session.visible == ()


def test_hidden_ones_are_not_visible_and_solo_ones_alone_are(session) -> None:
    for key in "abc":
        session.add(subject(key))
    heard = []
    session.visibility_changed.connect(lambda: heard.append(keys(session.visible)))
    session.set_hidden("b", True)
    session.set_solo("b", True)
    session.set_solo("b", False)
    session.show_all()
    assert heard == [["a", "c"], ["b"], ["a", "c"], ["a", "b", "c"]]


def test_a_reference_that_is_removed_is_none_any_more(session) -> None:
    session.add(subject("a"))
    session.add(subject("b"))
    session.set_reference("b")
    heard = []
    session.visibility_changed.connect(lambda: heard.append(session.reference))
    session.remove("b")
    assert heard == [None]
    session.set_reference("no such")
    assert session.reference is None


def test_moving_and_changing_keep_key_and_front(session) -> None:
    for key in "abc":
        session.add(subject(key))
    session.move("a", 5)
    assert keys(session.subjects) == ["b", "c", "a"]
    session.change("a", title="Other")
    assert (session.front.key, session.front.title) == ("a", "Other")
    session.change("gone", title="Nothing happens")
    assert keys(session.subjects) == ["b", "c", "a"]


@pytest.mark.parametrize(
    ("asked", "kept"),
    [
        ((30.0, 370.0), (30.0, 10.0)),
        ((-5.0, -180.0), (0.0, 180.0)),
        ((120.0, 540.0), (89.9, 180.0)),
        ((12.5, -90.0), (12.5, -90.0)),
    ],
)
def test_an_incidence_is_brought_into_its_range(session, asked, kept) -> None:
    session.set_incidence(*asked)
    assert session.incidence == pytest.approx(kept)


def test_the_light_stands_opposite_the_azimuth_and_is_reported_once(session) -> None:
    heard = []
    session.incidence_changed.connect(lambda theta, phi: heard.append((theta, phi)))
    session.set_incidence(60.0, 90.0)
    session.set_incidence(60.0, 90.0)
    np.testing.assert_allclose(session.light, [0.0, -np.sqrt(0.75), 0.5], atol=1e-12)
    session.reset_incidence()
    assert heard == [(60.0, 90.0), INCIDENCE_DEG]


def test_every_option_goes_back(session) -> None:
    session.set_options(channel="r", radius="log", cosine="none", shown="both")
    session.reset_options("radius")
    assert session.options == Options(channel="r", cosine="none", shown="both")
    session.reset_options()
    assert session.options == Options()


def test_a_lobe_that_is_switched_off_weighs_nothing_and_comes_back(session) -> None:
    weights = LobeWeights(
        np.array([5.0, 50.0]), np.ones(3), np.full((2, 3), 2.0), np.full((2, 3), 3.0), 0.7, 1.5
    )
    one = subject("a", fit=LobeFit(Material("fit", weights), "measured", weights, {}, (), 0.001))
    assert session.weights_of(subject("b")) is None
    assert session.weights_of(one) is weights
    session.switch_lobe("gloss", 1, False)
    session.switch_lobe("diffuse", 0, False)
    session.switch_lobe("directional", 9, False)  # of a fit with more lobes
    left = session.weights_of(one)
    np.testing.assert_array_equal(left.kg[:, 0], [3.0, 0.0])
    np.testing.assert_array_equal(left.kd, np.zeros(3))
    np.testing.assert_array_equal(left.kdd, weights.kdd)
    session.switch_lobe("diffuse", 0, True)
    np.testing.assert_array_equal(session.weights_of(one).kd, weights.kd)
