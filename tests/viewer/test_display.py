"""Exposure, tone curve, Fresnel and background: control to view to pixels."""

from __future__ import annotations

import numpy as np
import pytest


def changes(viewer, act) -> float:
    """Return the largest change of a pixel that ``act`` makes."""
    first = viewer.pixels().astype(int)
    act()
    return float(np.abs(viewer.pixels().astype(int) - first).max())


def test_exposure(viewer) -> None:
    first = viewer.pixels().mean()
    viewer.window.environment.exposure.slider.setValue(20)
    assert viewer.view.exposure_ev == pytest.approx(2.0)
    assert viewer.pixels().mean() > first + 20
    assert viewer.window.status.cell("exposure").text() == "+2.0 EV"


def test_rotation(viewer) -> None:
    assert changes(viewer, lambda: viewer.window.environment.rotation.number.setValue(90)) > 20
    assert viewer.view.rotation_deg == 90
    assert viewer.window.environment.rotation.slider.value() == 90


def test_background(viewer) -> None:
    box = viewer.window.environment.background

    def grey() -> None:
        box.setCurrentIndex(1)
        box.activated.emit(1)

    assert changes(viewer, grey) > 20
    corner = viewer.pixels()[:4, :4].reshape(-1, 3)
    assert np.ptp(corner.mean(axis=0)) < 1.5  # neutral


@pytest.mark.parametrize("index", [1, 2])
def test_tone_curve(viewer, index) -> None:
    curve = viewer.window.tone.curve
    assert changes(viewer, lambda: curve.activated.emit(index)) > 3
    assert viewer.view.tone_curve == curve.itemData(index)
    assert curve.currentIndex() == index


def test_fresnel_from_the_box_and_from_the_menu(viewer) -> None:
    assert changes(viewer, viewer.window.fresnel.on.click) > 3
    assert viewer.view.fresnel is False
    assert not viewer.window.commands.fresnel.isChecked()
    viewer.window.commands.fresnel.trigger()
    assert viewer.view.fresnel is True
    assert viewer.window.fresnel.on.isChecked()


def test_the_picture_goes_to_the_clipboard(viewer, qapp) -> None:
    viewer.window.commands.copy_wanted.emit()
    image = qapp.clipboard().image()
    assert (image.width(), image.height()) == viewer.window.picture.device_size
