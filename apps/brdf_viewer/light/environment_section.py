"""Which light, turned how far, how bright."""

from __future__ import annotations

from brdf_qt.fields.form import Form
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
    "auto": "Auto",
    "latlong": "Latitude-longitude",
    "horizontal_cross": "Cube, horizontal cross",
    "vertical_cross": "Cube, vertical cross",
    "horizontal_strip": "Cube, faces side by side",
    "vertical_strip": "Cube, faces one below another",
    "exr_cube": "Cube of OpenEXR",
    "angular": "Angular probe",
    "mirror_ball": "Mirror ball",
    "dome": "Dome, upper half",
}
BACKGROUND_TITLES = {
    "environment": "Environment",
    "blurred": "Environment, blurred",
    "grey": "Neutral grey",
    "colour": "Plain colour",
}


class EnvironmentSection(Section):
    """Which light, turned how far, how bright, and whether it is seen behind the surface."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("Environment", "environment", parent)
        self.chooser = SourceChooser("Open an environment file (.exr, .hdr, .brdfstudio)")
        self.rotation = SliderField("Rotation", "°", -180.0, 180.0, 1.0, 1, 0.0)
        self.exposure = SliderField("Exposure", "EV", -8.0, 8.0, 0.1, 2, 0.0)
        self.background = ChoiceBox(BACKGROUND_TITLES)
        self.background_colour = ColourButton("Colour of the background")
        self.layout_list = ChoiceBox(LAYOUT_TITLES)
        self.edit = QToolButton()
        self.edit.setText("Edit Light")
        self.edit.setToolTip("Edit this studio or sky in its own panel")
        self.facts = note()
        self.figures = EnvironmentFigures()
        form = Form()
        form.add_row("Light", self.chooser, "High-dynamic-range panorama or studio that lights the surface")
        form.add_row(
            "Projection", self.layout_list, "Projection of the image; choose it where detection fails"
        )
        self._edit_label = form.add_row("", self.edit)
        form.add_wide(self.facts)
        form.add_wide(self.figures)
        form.add_row("Rotation", self.rotation, PARAMETERS["rotation_deg"].meaning + " (Alt + drag)")
        form.add_row("Exposure", self.exposure, PARAMETERS["exposure_ev"].meaning)
        form.add_row("Background", self.background, "Visible background; the light does not change")
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
