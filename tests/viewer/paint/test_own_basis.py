"""A basis of the user's own in the Viewer: light, paints and what they are compared with are all of its exponents."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

from brdf_qt.window.fit_choice import FitChoice

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Sparkle
from brdf_suite.fitting.lobes.settings import FitSettings

OWN = (2.0, 30.0, 900.0)


def test_everything_is_fitted_and_filtered_for_the_stored_choice(start, lights, tmp_path: Path) -> None:
    path = tmp_path / "own.json"
    results = [{"exponents": list(OWN)}]
    path.write_text(
        json.dumps({"format": "lobe_basis", "version": 1, "default_count": 3, "results": results})
    )
    view = View(environment=str(lights["bright"]), surface="sphere", sparkle=Sparkle(mode="off"))
    choice = FitChoice(str(path), diffuse="measured")

    usual = start(view=view)
    assert usual.state.fitting == FitSettings()
    usual.controller.fit.choose(choice)
    assert usual.state.fitting == FitSettings()  # until the next start
    usual.close()

    viewer = start(view=view)
    state = viewer.state
    assert state.fitting == choice.settings()
    assert tuple(state.fit.weights.exponents) == OWN
    assert state.environment.value.maps.exponents[-1] == 900.0
    assert state.fit_words == (f"--basis={path}", "--diffuse=measured")
    viewer.controller.paint.open("copper")
    viewer.wait_idle()
    assert state.fit.name == "Copper"
    assert tuple(state.fit.weights.exponents) == OWN
    state.change_view(compare=replace(state.view.compare, mode="swipe", paint="solid_red"))
    viewer.qtbot.waitUntil(lambda: state.second is not None)
    assert tuple(state.second.value.weights.exponents) == OWN
    assert viewer.pixels().max() > 0
    assert not viewer.window.picture.failure
