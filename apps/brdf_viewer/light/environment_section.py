"""Which light, turned how far, how bright."""

from __future__ import annotations

from brdf_qt.fields.form import Form
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Section
from PySide6.QtWidgets import QToolButton, QWidget

from brdf_suite.documents.view import PARAMETERS
from brdf_viewer.fields.choice_box import ChoiceBox
from brdf_viewer.fields.colour_button import ColourButton
from brdf_viewer.fields.note import note
from brdf_viewer.fields.slider import SliderField
from brdf_viewer.fields.source_chooser import SourceChooser
from brdf_viewer.light.environment_figures import EnvironmentFigures

LAYOUT_TITLES = {
    "auto": mark("Auto"),
    "latlong": mark("Latitude-longitude"),
    "horizontal_cross": mark("Cube, horizontal cross"),
    "vertical_cross": mark("Cube, vertical cross"),
    "horizontal_strip": mark("Cube, faces side by side"),
    "vertical_strip": mark("Cube, faces one below another"),
    "exr_cube": mark("Cube of OpenEXR"),
    "angular": mark("Angular probe"),
    "mirror_ball": mark("Mirror ball"),
    "dome": mark("Dome, upper half"),
}
BACKGROUND_TITLES = {
    "environment": mark("Environment"),
    "blurred": mark("Environment, blurred"),
    "grey": mark("Neutral grey"),
    "colour": mark("Plain colour"),
}


class EnvironmentSection(Section):
    """Which light, turned how far, how bright, and whether it is seen behind the surface."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Environment"), "environment", parent)
        self.chooser = SourceChooser(tr("Open an environment file (.exr, .hdr, .brdfstudio)"))
        self.rotation = SliderField(tr("Rotation"), "°", -180.0, 180.0, 1.0, 1, 0.0)
        self.exposure = SliderField(tr("Exposure"), "EV", -8.0, 8.0, 0.1, 2, 0.0)
        self.background = ChoiceBox(BACKGROUND_TITLES)
        self.background_colour = ColourButton(tr("Colour of the background"))
        self.layout_list = ChoiceBox(LAYOUT_TITLES)
        self.edit = QToolButton()
        self.edit.setText(tr("Edit Light"))
        self.edit.setToolTip(tr("Edit this studio or sky in its own panel"))
        self.facts = note()
        self.figures = EnvironmentFigures()
        turned = tr("{meaning} (Alt + drag)").format(meaning=tr(PARAMETERS["rotation_deg"].meaning))
        form = Form()
        form.add_row(
            tr("Light"), self.chooser, tr("High-dynamic-range panorama or studio that lights the surface")
        )
        form.add_row(
            tr("Projection"), self.layout_list, tr("Projection of the image; choose it where detection fails")
        )
        self._edit_label = form.add_row("", self.edit)
        form.add_wide(self.facts)
        form.add_wide(self.figures)
        form.add_row(
            tr("Rotation"),
            self.rotation,
            turned,
        )
        form.add_row(tr("Exposure"), self.exposure, tr(PARAMETERS["exposure_ev"].meaning))
        form.add_row(tr("Background"), self.background, tr("Visible background; the light does not change"))
        self._colour_label = form.add_row("", self.background_colour)
        self.add(form)

    def set_background(self, key: str, colour: tuple[float, float, float]) -> None:
        """Show the present background, and its ``colour`` (encoded sRGB, 0 to 1) where it has one."""
        self.background.show_choice(key)
        self.background_colour.set_colour(colour)
        self._colour_label.setVisible(key == "colour")  # an empty label keeps its row open
        self.background_colour.setVisible(key == "colour")

    def set_layout(self, key: str, choosable: bool) -> None:
        """Show the present layout; only a file of pixels has a choice of it."""
        self.layout_list.show_choice(key)
        self.layout_list.setEnabled(choosable)

    def set_editable(self, editable: bool) -> None:
        """Offer to edit the light where it has a description."""
        self._edit_label.setVisible(editable)
        self.edit.setVisible(editable)
