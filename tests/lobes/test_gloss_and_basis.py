"""Seven lobes and no gloss, as in Figure 4 of Westlund and Meyer: chosen, not built in."""

from __future__ import annotations

import argparse

import numpy as np
import pytest
from brdf_lobe_visualizer.cuts.lines import SliceLines
from brdf_lobe_visualizer.script import add_fit, parse_fit
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial
from brdf_qt.window.fit_choice import FitChoice

from brdf_suite.fitting.lobes.basis import default_basis, shipped_basis
from brdf_suite.inspection.slices.cuts import plane_slice
from brdf_suite.inspection.slices.images import image_error, image_of, unrolled_pairs
from brdf_suite.pipeline.material import Material
from brdf_suite.reflectance.models.lambertian import Lambertian


@pytest.fixture
def seven(program, opened, qtbot):
    """A paint that is fitted by seven lobes, the diffuse term as measured; the default fit comes back afterwards."""
    opened("blue")
    assert len(program.session.front.fit.weights.exponents) == default_basis().count
    program.fit.choose(FitChoice(count=7, diffuse="measured"))
    qtbot.waitUntil(lambda: program.is_idle, timeout=60_000)
    yield program
    program.fit.choose(FitChoice())
    qtbot.waitUntil(lambda: program.is_idle, timeout=60_000)


def test_another_basis_fits_every_subject_anew(seven) -> None:
    fit = seven.session.front.fit
    assert tuple(fit.weights.exponents) == shipped_basis(7).exponents
    assert fit.settings.diffuse == "measured"


def test_figure_4_of_the_paper(seven) -> None:
    session = seven.session
    whole, before = session.front.reflectance, session.weights_of(session.front)
    assert session.target_of(session.front) is whole
    assert before.kg.any()
    session.set_options(gloss=False)
    target, lobes = session.target_of(session.front), session.weights_of(session.front)
    assert target is whole.base
    assert target is session.target_of(session.front)  # the same object: views compare by identity
    assert not lobes.kg.any()
    np.testing.assert_array_equal(lobes.kdd, before.kdd)
    # Weights of 45°: at 70° the clearcoat darkens the target more than the fit.
    for incidence, bound in ((10.0, 0.2), (40.0, 0.2), (70.0, 0.6)):
        pairs = unrolled_pairs(incidence, 0.0, 64)
        above, below = (image_of(one, pairs, cosine="light") for one in (target, lobes))
        assert image_error(above, below).relative < bound
        assert image_error(image_of(whole, pairs, cosine="light"), below).relative > 0.8


def test_curves_leave_the_gloss_out(seven) -> None:
    session = seven.session
    session.set_options(shown="both")
    cuts = [plane_slice(45.0, 0.0)]
    lines = SliceLines(session)

    def peaks() -> list[float]:
        return [float(np.nanmax(line.value)) for line in lines.of(cuts)[0].lines]

    with_gloss = peaks()
    session.set_options(gloss=False)
    assert all(without < 0.2 * peak for without, peak in zip(peaks(), with_gloss, strict=True))
    session.set_options(gloss=True)
    assert peaks() == with_gloss


def test_data_that_nothing_divides_are_shown_whole(program) -> None:
    session = program.session
    session.add(PlottedMaterial("matt", "matt", Material("matt", Lambertian((0.2, 0.3, 0.4)))))
    session.set_options(gloss=False)
    assert session.target_of(session.front) is session.front.reflectance


def test_options_of_a_run() -> None:
    parser = argparse.ArgumentParser()
    add_fit(parser)
    assert parse_fit(parser.parse_args([])) is None
    words = ["--lobe-count", "7", "--weighting", "solid-angle", "--diffuse", "measured"]
    assert parse_fit(parser.parse_args(words)) == FitChoice("", 7, "solid angle", "measured")
