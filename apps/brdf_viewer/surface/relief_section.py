"""Small shapes of the paint and a second colour: orange peel, a normal map, a mask for two-tone paint."""

from __future__ import annotations

from brdf_qt.fields.choices import ChoiceBox, note, set_note
from brdf_qt.fields.form import Form, fill_row, icon_button
from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.fields.number import NumberField, reach_of
from brdf_qt.program.names import title_of
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Section
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QSizePolicy, QWidget

from brdf_suite.documents.paint import OrangePeel
from brdf_suite.documents.view_settings import PARAMETERS, Relief, TwoTone
from brdf_suite.surface.orange_peel import height_rms_um
from brdf_viewer.paint.pickers import two_tone_picker

PROJECTION_TITLES = {
    "uv": mark("Tiled"),
    "side": mark("Projected from the side"),
    "front": mark("Projected from the front"),
    "top": mark("Projected from above"),
}


class FileChoice(QWidget):
    """A file that may be none: its name, a button that asks for one, and one that takes it away."""

    def __init__(self, open_tip: str, clear_tip: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.name = PlainLabel(tr("None"))
        self.name.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.open = icon_button("folder-open", open_tip)
        self.clear = icon_button("x", clear_tip)
        fill_row(self, self.name, self.open, self.clear, spacing=4)
        self.setFocusProxy(self.open)
        self.set_path(None)

    def set_path(self, path: str | None) -> None:
        """Show a file's name, or that there is none."""
        self.name.setText(tr("None") if path is None else title_of(path))
        self.name.setToolTip(plain_tip(path or ""))
        self.clear.setEnabled(path is not None)


class ReliefSection(Section):
    """Emits ``edited(part, field, value)``, the part of the view being ``relief`` or ``two_tone``; setters are silent.

    ``daily`` has the orange peel and the second paint. ``browse_requested(part, field)`` asks for a file.
    """

    edited = Signal(str, str, object)
    browse_requested = Signal(str, str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Relief and two-tone"), "relief", parent)
        self.daily = Form()
        self.orange_peel = self._number("relief", "orange_peel", 0.02, 2)
        self.orange_peel_mm = self._number("relief", "orange_peel_mm", 0.5, 1)
        self.peel_facts = note()
        self._relief = Relief()
        self._own_peel: OrangePeel | None = None
        files = (tr("Open a normal map"), tr("Remove the normal map"))
        self.normal_map = self._file("relief", "normal_map", *files)
        files = (tr("Open a tangent map"), tr("Remove the tangent map"))
        self.tangent_map = self._file("relief", "tangent_map", *files)
        self.normal_strength = self._number("relief", "normal_strength", 0.1, 2)
        self.normal_width_mm = self._number("relief", "normal_width_mm", 10.0, 1)
        self.paint = two_tone_picker()
        self.paint.chosen.connect(lambda key: self.edited.emit("two_tone", "paint", key or None))
        self.paint.browse_requested.connect(lambda: self.browse_requested.emit("two_tone", "paint"))
        self.mask_file = self._file("two_tone", "mask", tr("Open a mask"), tr("Remove the mask"))
        self.projection = ChoiceBox(PROJECTION_TITLES)
        self.projection.picked.connect(lambda key: self.edited.emit("two_tone", "projection", key))
        self.mask_width_mm = self._number("two_tone", "mask_width_mm", 50.0, 1, tr("Mask width"))
        self.two_tone_facts = note(lines=1)
        self.daily.add_row(tr("Orange peel"), self.orange_peel, tr(PARAMETERS["relief.orange_peel"].meaning))
        self.daily.add_row(tr("Second paint"), self.paint, tr("Shown where the mask is white"))
        self.daily.add_wide(self.two_tone_facts)
        form = self.add(Form())
        form.add_row(tr("Wavelength"), self.orange_peel_mm, tr(PARAMETERS["relief.orange_peel_mm"].meaning))
        form.add_wide(self.peel_facts)
        tip = tr("An image of normals (PNG, EXR …), tiled over the paint")
        form.add_row(tr("Normal map"), self.normal_map, tip)
        tip = tr("An image of the grain's direction in anisotropic factored paints")
        form.add_row(tr("Tangent map"), self.tangent_map, tip)
        form.add_row(tr("Strength"), self.normal_strength, tr(PARAMETERS["relief.normal_strength"].meaning))
        form.add_row(tr("Tile width"), self.normal_width_mm, tr(PARAMETERS["relief.normal_width_mm"].meaning))
        form.add_row(tr("Mask"), self.mask_file, tr("An image: black is the first paint, white the second"))
        form.add_row(tr("Mapping"), self.projection, tr("Mapping of the mask onto the surface"))
        form.add_row(tr("Mask width"), self.mask_width_mm, tr(PARAMETERS["two_tone.mask_width_mm"].meaning))

    def set_relief(self, relief: Relief) -> None:
        for name in ("orange_peel", "orange_peel_mm", "normal_strength", "normal_width_mm"):
            getattr(self, name).set_value(getattr(relief, name))
        self.normal_map.set_path(relief.normal_map)
        self.tangent_map.set_path(relief.tangent_map)
        self._relief = relief
        self._show_peel()

    def set_own_peel(self, peel: OrangePeel | None) -> None:
        """Show the orange peel that the paint itself has; it is drawn while the view sets none."""
        self._own_peel = peel
        self._show_peel()

    def _show_peel(self) -> None:
        relief, own, text = self._relief, self._own_peel, ""
        if relief.orange_peel > 0.0:
            height = height_rms_um(relief.orange_peel, relief.orange_peel_mm)
            text = tr("Waves of {height:.2g} µm (RMS height)").format(height=height)
            if own is not None:
                text = tr("{waves}, instead of the paint's own").format(waves=text)
        elif own is not None:
            text = tr(
                "The paint's own: {height:g} µm (RMS height), {length:g} mm. A slope set here replaces it."
            )
            text = text.format(height=own.amplitude_um, length=own.wavelength_mm)
        set_note(self.peel_facts, text)

    def set_two_tone(self, two_tone: TwoTone, title: str) -> None:
        """Show the second paint, by its ``title``, and where it is."""
        self.paint.show_source(two_tone.paint or "", title)
        self.mask_file.set_path(two_tone.mask)
        self.projection.show_choice(two_tone.projection)
        self.mask_width_mm.set_value(two_tone.mask_width_mm)
        self.mask_width_mm.setEnabled(two_tone.projection == "uv")
        missing = ""
        if two_tone.paint is not None and two_tone.mask is None:
            missing = tr("Open a mask to see the second paint.")
        elif two_tone.mask is not None and two_tone.paint is None:
            missing = tr("Choose a second paint to see the mask.")
        set_note(self.two_tone_facts, missing)

    def _number(self, part: str, field: str, step: float, decimals: int, label: str = "") -> NumberField:
        parameter = PARAMETERS[f"{part}.{field}"]
        made = NumberField(label or tr(parameter.label), *reach_of(parameter, step, decimals))
        made.edited.connect(lambda value: self.edited.emit(part, field, value))
        return made

    def _file(self, part: str, field: str, open_tip: str, clear_tip: str) -> FileChoice:
        made = FileChoice(open_tip, clear_tip)
        made.setObjectName(f"relief_{field}")
        made.open.clicked.connect(lambda: self.browse_requested.emit(part, field))
        made.clear.clicked.connect(lambda: self.edited.emit(part, field, None))
        return made
