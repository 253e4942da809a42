"""How lobes follow the angle of view, and where in the maps they are looked up."""

from __future__ import annotations

from brdf_qt.fields.form import Form
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Section
from PySide6.QtWidgets import QWidget

from brdf_viewer.fields.inspector import ChoiceBox

FRESNEL_TITLES = {"raised": mark("Raised"), "multi_angle": mark("Several angles"), "off": mark("Off")}
FRESNEL_TIPS = {
    "raised": mark(
        "The lobes fitted at 45°, with the coat brightened and the base dimmed by the exact Fresnel equations"
    ),
    "multi_angle": mark(
        "Lobes fitted at 16 angles of incidence and interpolated, also in their shape; measured files, "
        "which have no separate coat, are raised"
    ),
    "off": mark("The lobes of 45° at every angle"),
}
LOOK_UP_TITLES = {"shifted": mark("Shifted (exact horizon)"), "paper": mark("Mirror direction (paper)")}
LOOK_UP_TIPS = {
    "shifted": mark(
        "Each lobe is looked up between mirror direction and normal: only light above the surface counts"
    ),
    "paper": mark(
        "Each lobe is looked up in the mirror direction and dimmed by its cosine, as published by Westlund and "
        "Meyer: broad lobes take light from below the surface, towards grazing angles"
    ),
}


class FresnelSection(Section):
    """The Fresnel mode and the form of the look-up, words of :class:`documents.view.View`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Fresnel"), "fresnel", parent)
        self.mode = ChoiceBox(FRESNEL_TITLES, FRESNEL_TIPS)
        self.look_up = ChoiceBox(LOOK_UP_TITLES, LOOK_UP_TIPS)
        form = Form()
        form.add_row(tr("Coat and base"), self.mode, tr("Dependence on the viewing angle"))
        tip = tr("Direction in which a lobe is looked up in the filtered light")
        form.add_row(tr("Look-up"), self.look_up, tip)
        self.add(form)
