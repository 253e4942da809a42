"""A basis of the user's own in Designer: paint and variations are of its exponents."""

from __future__ import annotations

import json

from brdf_qt.window.fit_choice import FitChoice

OWN = (2.0, 30.0, 900.0)


def test_the_next_designer_fits_with_what_was_chosen(
    qtbot, dialogs, own_session, monkeypatch, tmp_path
) -> None:
    from brdf_designer.assembly import Designer
    from brdf_qt.work import pictures

    monkeypatch.setattr(pictures, "child_command", lambda _module: [])
    path = tmp_path / "own.json"
    results = [{"exponents": list(OWN)}]
    path.write_text(
        json.dumps({"format": "lobe_basis", "version": 1, "default_count": 3, "results": results})
    )
    first = Designer(dialogs=lambda _window: dialogs)
    qtbot.addWidget(first.window)
    first.fit.choose(FitChoice(str(path), weighting="relative"))
    assert len(first.session.fit.weights.exponents) > 3
    first.close()
    second = Designer(dialogs=lambda _window: dialogs)
    qtbot.addWidget(second.window)
    assert tuple(second.session.fit.weights.exponents) == OWN
    assert second.session.fit.settings == second.session.fitting
    assert second.session.fitting.weighting == "relative"
    second.close()
