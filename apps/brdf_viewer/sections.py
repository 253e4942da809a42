"""The inspector's sections: widgets with intents (signals) and setters, and no knowledge of a scene."""

from __future__ import annotations

from brdf_qt.fit_error import fit_tips, is_large, marked
from brdf_qt.form import Form
from brdf_qt.number_field import NumberField
from brdf_qt.section import Section
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QButtonGroup, QCheckBox, QComboBox, QGridLayout, QLabel, QToolButton, QWidget

from brdf_suite.documents.view import PARAMETERS, Camera
from brdf_viewer.environment_figures import EnvironmentFigures
from brdf_viewer.paint_patches import PaintPatches
from brdf_viewer.slider_field import SliderField
from brdf_viewer.source_chooser import SourceChooser

TONE_TITLES = {
    "faithful": "Faithful, soft highlights",
    "neutral": "Neutral (Khronos PBR)",
    "characteristic": "Characteristic curve",
    "linear": "Linear, clipped",
}
TONE_TIPS = {
    "faithful": "Shows the colours as they are; rolls off only what is brighter than 0.8",
    "neutral": "Takes 4 % of reflection off the darks, keeps hue and saturation, rolls highlights off",
    "characteristic": "A film's S-shaped response in log exposure",
    "linear": "No curve: the one for judging a colour; too bright is cut off",
}
LAYOUT_TITLES = {
    "auto": "As its shape tells",
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
BACKGROUND_TITLES = {"environment": "Environment", "grey": "Neutral grey"}


def note(text: str = "") -> QLabel:
    """Return a small label for facts under a field; hidden while it is empty."""
    label = QLabel(text)
    label.setWordWrap(True)
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    label.setVisible(bool(text))
    return label


def set_note(label: QLabel, text: str) -> None:
    """Show ``text``, or hide the label where it is empty."""
    label.setText(text)
    label.setVisible(bool(text))


class EnvironmentSection(Section):
    """Which light, turned how far, how bright, and whether it is seen behind the surface."""

    rotation_edited = Signal(float)
    exposure_edited = Signal(float)
    background_edited = Signal(str)
    layout_edited = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("Environment", "environment", parent)
        self.chooser = SourceChooser("Open an environment file (.exr, .hdr, .brdfstudio)")
        self.rotation = SliderField("Rotation", "°", -180.0, 180.0, 1.0, 1, 0.0)
        self.rotation.edited.connect(self.rotation_edited)
        self.exposure = SliderField("Exposure", "EV", -8.0, 8.0, 0.1, 2, 0.0)
        self.exposure.edited.connect(self.exposure_edited)
        self.background = QComboBox()
        for key, title in BACKGROUND_TITLES.items():
            self.background.addItem(title, key)
        self.background.activated.connect(
            lambda index: self.background_edited.emit(self.background.itemData(index))
        )
        self.layout_list = QComboBox()
        for key, title in LAYOUT_TITLES.items():
            self.layout_list.addItem(title, key)
        self.layout_list.activated.connect(
            lambda index: self.layout_edited.emit(self.layout_list.itemData(index))
        )
        self.facts = note()
        self.figures = EnvironmentFigures()
        form = Form()
        form.add_row("Light", self.chooser, "A high-dynamic-range panorama, or a studio, lights the surface")
        form.add_row("Layout", self.layout_list, "How a file's image is laid out, where its shape misleads")
        form.add_wide(self.facts)
        form.add_wide(self.figures)
        form.add_row("Rotation", self.rotation, PARAMETERS["rotation_deg"].meaning + " (Alt + drag)")
        form.add_row("Exposure", self.exposure, PARAMETERS["exposure_ev"].meaning)
        form.add_row("Background", self.background, "What is seen behind the surface; the light stays")
        self.add(form)

    def set_background(self, key: str) -> None:
        """Show the present background."""
        self.background.setCurrentIndex(self.background.findData(key))

    def set_layout(self, key: str, choosable: bool) -> None:
        """Show the present layout; only a file of pixels has a choice of it."""
        self.layout_list.setCurrentIndex(self.layout_list.findData(key))
        self.layout_list.setEnabled(choosable)


class SurfaceSection(Section):
    """Which form carries the paint."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("Surface", "surface", parent)
        self.chooser = SourceChooser("Open a mesh (.glb, .gltf, .obj, .stl, .ply)")
        self.facts = note()
        form = Form()
        form.add_row("Form", self.chooser, "The surface on which the paint is judged")
        form.add_wide(self.facts)
        self.add(form)


class PaintSection(Section):
    """Which paint: the one in Designer, a shipped one, or a file; and what the fit makes of it."""

    follow_edited = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("Paint", "paint", parent)
        self.follow = QCheckBox("Follow Designer")
        self.follow.setToolTip("Show the paint that is being edited in Designer, at every change")
        self.follow.clicked.connect(self.follow_edited)
        self.chooser = SourceChooser("Open a paint (.brdfpaint)")
        self.patches = PaintPatches()
        self.fit, self.facts = note(), note()
        form = Form()
        form.add_row("", self.follow)
        form.add_row("Paint", self.chooser, "Taking another paint ends following Designer")
        form.add_wide(self.patches)
        form.add_wide(self.fit)
        form.add_wide(self.facts)
        self.add(form)

    def set_fit_error(self, worst_delta_e: float | None, time_limited: bool, exact_follows: bool) -> None:
        """Show the largest ΔE00 at the measured angles, None where there is none; a large one stands out."""
        limited = ", time-limited" if time_limited else ""
        if worst_delta_e is None:
            text = f"Fit: no angle to compare colours at{limited}"
        else:
            bound = f"Fit: ΔE00 at most {worst_delta_e:.2f} at the measured angles{limited}"
            text = marked(bound, worst_delta_e)
        set_note(self.fit, text)
        font = self.fit.font()
        font.setBold(worst_delta_e is not None and is_large(worst_delta_e))
        self.fit.setFont(font)
        self.fit.setToolTip(fit_tips(worst_delta_e, time_limited, exact_follows))

    def set_following(self, following: bool, linked: bool) -> None:
        """Show whether Designer is followed, and whether it is there."""
        self.follow.setChecked(following)
        self.follow.setText("Follow Designer" if linked else "Follow Designer (not open)")


class CameraSection(Section):
    """From where the surface is seen, by preset or by number, and through which lens."""

    preset_chosen = Signal(str)
    azimuth_edited = Signal(float)
    elevation_edited = Signal(float)
    focal_length_edited = Signal(float)

    def __init__(self, presets: dict[str, str], parent: QWidget | None = None) -> None:
        super().__init__("Camera", "camera", parent)
        buttons = QWidget()
        row = QGridLayout(buttons)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(4)
        self.presets = QButtonGroup(self)
        self.presets.setExclusive(False)
        for index, (key, title) in enumerate(presets.items()):
            button = QToolButton()
            button.setText(title)
            button.setObjectName(f"preset_{key}")
            button.setToolTip(f"Look from the {title.lower()} side ({index + 1})")
            button.setSizePolicy(button.sizePolicy().Policy.Expanding, button.sizePolicy().Policy.Fixed)
            button.clicked.connect(lambda _=False, key=key: self.preset_chosen.emit(key))
            self.presets.addButton(button)
            row.addWidget(button, 0, index)
        start = Camera()
        self.azimuth = NumberField("Azimuth", "°", -180.0, 180.0, 1.0, 1, start.azimuth_deg)
        self.azimuth.setWrapping(True)
        self.azimuth.edited.connect(self.azimuth_edited)
        self.elevation = NumberField("Elevation", "°", -89.0, 89.0, 1.0, 1, start.elevation_deg)
        self.elevation.edited.connect(self.elevation_edited)
        focal_length = start.focal_length_mm
        self.focal_length = NumberField("Focal length", "mm", 12.0, 400.0, 1.0, 0, focal_length)
        self.focal_length.edited.connect(self.focal_length_edited)
        form = Form()
        form.add_wide(buttons)
        form.add_row("Azimuth", self.azimuth, PARAMETERS["camera.azimuth_deg"].meaning)
        form.add_row("Elevation", self.elevation, PARAMETERS["camera.elevation_deg"].meaning)
        form.add_row("Focal length", self.focal_length, PARAMETERS["camera.focal_length_mm"].meaning)
        self.add(form)


class FresnelSection(Section):
    """Whether the coat brightens towards grazing angles."""

    fresnel_edited = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("Fresnel", "fresnel", parent)
        self.on = QCheckBox("Coat brightens towards grazing")
        self.on.setToolTip("Exact dielectric Fresnel on the sharp lobes; off shows the fit as it is at 45°")
        self.on.clicked.connect(self.fresnel_edited)
        self.add(self.on)


class ToneSection(Section):
    """How radiance becomes the light of the screen."""

    tone_curve_edited = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("Tone", "tone", parent)
        self.curve = QComboBox()
        for key, title in TONE_TITLES.items():
            self.curve.addItem(title, key)
            self.curve.setItemData(self.curve.count() - 1, TONE_TIPS[key], Qt.ItemDataRole.ToolTipRole)
        self.curve.activated.connect(lambda index: self.tone_curve_edited.emit(self.curve.itemData(index)))
        form = Form()
        form.add_row("Tone curve", self.curve, "From radiance to the screen, before gamma")
        self.add(form)

    def set_curve(self, key: str) -> None:
        """Show the present curve."""
        self.curve.setCurrentIndex(self.curve.findData(key))
