"""Step 1: the folder of photographs, the numbers of the rig, and what is wrong with it by file and reason."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from brdf_qt.fields.form import Form, described
from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHeaderView, QTreeWidget, QTreeWidgetItem

from brdf_designer.acquire.plots.view import PictureView
from brdf_designer.acquire.session.start_page import StartPage
from brdf_designer.acquire.states import Problem
from brdf_designer.acquire.step_page import AcquirePage, Facts
from brdf_designer.window.widgets import button, wrapped
from brdf_suite.acquisition.session.session import Session

# Of each number by the end of its key: range, step and decimals of its field, in millimetres or degrees.
_REACHES = {
    "radius_m": (0.1, 10_000.0, 0.1, 2),
    "distance_m": (10.0, 100_000.0, 1.0, 1),
    "height_m": (-50_000.0, 50_000.0, 1.0, 1),
    "tilt_deg": (-89.0, 89.0, 0.1, 2),
    "angle_offset_deg": (-45.0, 45.0, 0.1, 2),
}
_HEIGHT_TIP = mark("Height above the centre of the sphere")
_CAMERA_TIP = mark("Horizontal distance from the centre of projection to the axis of the turntable")
_LAMP_TIP = mark("Horizontal distance from the lamp to the axis of the turntable")
_OFFSET_TIP = mark("Known zero error of the turntable; added to every stated angle")
NUMBERS = (
    ("sphere.radius_m", mark("Sphere radius"), mark("Radius of the painted sphere")),
    ("camera.distance_m", mark("Camera distance"), _CAMERA_TIP),
    ("camera.height_m", mark("Camera height"), _HEIGHT_TIP),
    ("camera.tilt_deg", mark("Camera tilt"), mark("Tilt of the optical axis, positive upwards")),
    ("light.distance_m", mark("Lamp distance"), _LAMP_TIP),
    ("light.height_m", mark("Lamp height"), _HEIGHT_TIP),
    ("light.angle_offset_deg", mark("Angle offset"), _OFFSET_TIP),
)
"""Key in the session, name and explanation."""
_MM = 1e3
_SIGNS = {
    "error": ("warning-octagon-fill", "bad"),
    "warning": ("warning-fill", "warning"),
    "info": ("info", ""),
}
_MOST_ROWS = 8
_RESPONSES = {"unknown": mark("unknown"), "linear": mark("linear"), "srgb": mark("sRGB")}
_WORDS = {"error": mark("Error"), "warning": mark("Warning"), "info": mark("Note")}


class SessionPage(AcquirePage):
    """The page of the session.

    Intents: ``open_requested()``, ``template_requested()``, ``sample_requested()``, ``check_requested()``,
    ``number_edited(key, value)`` in the unit of the field.
    """

    open_requested = Signal()
    template_requested = Signal()
    sample_requested = Signal()
    check_requested = Signal()
    number_edited = Signal(str, float)

    def __init__(self) -> None:
        super().__init__(
            "session",
            tr("Photographs of the painted sphere in a folder, described by a session.json."),
        )
        self.picture = PictureView(tr("A photograph of the session"))
        self.start = StartPage()
        self.start.open_requested.connect(self.open_requested)
        self.start.template_requested.connect(self.template_requested)
        self.start.sample_requested.connect(self.sample_requested)
        self.centre.addWidget(self.start, 3)
        self.centre.addWidget(self.picture, 3)
        self.problems = problem_list(tr("Problems of the session"))
        self.verdict = wrapped()
        self.centre.addWidget(self.verdict)
        self.centre.addWidget(self.problems, 2)
        # One below the other: beside each other they are wider than the panel in some languages.
        opening = button(
            tr("Open Folder…"), tr("Open a folder with a session.json"), self.open_requested.emit
        )
        making = button(
            tr("New Folder…"),
            tr("Create a folder with a session.json template for new photographs"),
            self.template_requested.emit,
        )
        self.folder = described(wrapped(), spoken=tr("Folder"))
        self.check_button = button(
            tr("Check Again"), tr("Check all photographs of the folder again"), self.check_requested.emit
        )
        self.add_part("folder", tr("Folder"), self.folder, opening, making, self.check_button)
        form = Form()
        self.fields: dict[str, NumberField] = {}
        for key, name, tip in NUMBERS:
            low, high, step, decimals = _REACHES[key.partition(".")[2]]
            unit = "mm" if key.endswith("_m") else "°"
            field = NumberField(tr(name), unit, low, high, step, decimals, low)
            field.edited.connect(lambda value, key=key: self.number_edited.emit(key, value))
            form.add_row(tr(name), field, tr(tip))
            self.fields[key] = field
        kept = wrapped(tr("Changes are saved immediately. Undo: Ctrl+Z."))
        self.rig = self.add_part("rig", tr("Rig"), form, kept)
        self.facts = Facts(tr("Contents of the session"))
        self.about = self.add_part("photographs", tr("Photographs"), self.facts)
        self.show_session(None, None)

    def show_session(self, folder: Path | None, session: Session | None) -> None:
        """Show a session, or what to do where none is open."""
        for widget in (self.rig, self.about, self.check_button):
            widget.setVisible(session is not None)
        self.picture.setVisible(session is not None)
        self.start.setVisible(session is None)
        if session is None:
            self.folder.setText(tr("No folder is open."))
            self.show_problems(None)
            return
        self.folder.setText(str(folder))
        for key, field in self.fields.items():
            part, name = key.split(".")
            value = float(getattr(getattr(session, part), name))
            field.set_value(_MM * value if name.endswith("_m") else value)
        first, last = session.positions[0].angle_deg, session.positions[-1].angle_deg
        short, long = 1e3 * session.exposures_s[0], 1e3 * session.exposures_s[-1]
        camera = session.camera
        rows = [
            (tr("Name"), session.name, tr("Name in session.json")),
            (
                tr("Positions"),
                tr("{count}, {first:g} to {last:g}°").format(
                    count=len(session.positions), first=first, last=last
                ),
                tr("Lamp angles; 0° is at the camera"),
            ),
            (
                tr("Exposures"),
                tr("{count}, {short:g} to {long:g} ms").format(
                    count=len(session.exposures_s), short=short, long=long
                ),
                tr("Exposures of each position, shortest first"),
            ),
            (
                tr("Codes"),
                tr("{bits} bits, response: {response}").format(
                    bits=camera.bit_depth, response=tr(_RESPONSES[camera.response])
                ),
                tr("Encoding of the pixel values"),
            ),
        ]
        if session.date:
            rows.append((tr("Date"), session.date, tr("Name in session.json")))
        if session.dark:
            rows.append(("", tr("With dark frames"), ""))
        if session.white is not None:
            rows.append(("", tr("With a white reference"), ""))
        if session.flat_field is not None:
            rows.append(("", tr("With a flat field"), ""))
        if camera.board is not None:
            count = len(camera.board.photographs)
            rows.append(("", tr("With {count} photographs of a board").format(count=count), ""))
        if session.notes:
            rows.append((tr("Notes"), session.notes, tr("Name in session.json")))
        self.facts.show_rows(rows)

    def keep_opened(self) -> None:
        """Take the numbers that are shown for those that a double click goes back to."""
        for field in self.fields.values():
            field.set_default(field.value())

    def show_problems(self, problems: Sequence[Problem] | None, photographs: int = 0) -> None:
        """List what was found; ``None`` while nothing was looked at."""
        fill_problems(self.problems, problems or ())
        self.problems.setVisible(bool(problems))
        if problems is None:
            self.verdict.hide()
            return
        self.verdict.show()
        wrong = sum(problem.severity == "error" for problem in problems)
        if wrong:
            self.verdict.setText(
                tr("Errors: {count}. Fix them, or the affected photographs are skipped.").format(count=wrong)
            )
        elif problems:
            self.verdict.setText(tr("No errors. Notes: {count}.").format(count=len(problems)))
        else:
            self.verdict.setText(tr("{count} photographs checked, no problems.").format(count=photographs))


def problem_list(name: str) -> QTreeWidget:
    """Return an empty list of problems."""
    made = described(QTreeWidget(), spoken=name, tip=tr("Problems found by the check: file, kind and reason"))
    made.setHeaderLabels([tr("Kind"), tr("File"), tr("Reason")])
    made.setRootIsDecorated(False)
    made.setWordWrap(True)
    made.setTextElideMode(Qt.TextElideMode.ElideNone)
    made.setUniformRowHeights(False)
    header = made.header()
    modes = QHeaderView.ResizeMode
    for column, mode in enumerate((modes.ResizeToContents, modes.ResizeToContents, modes.Stretch)):
        header.setSectionResizeMode(column, mode)
    header.setStretchLastSection(True)
    return made


def fill_problems(rows: QTreeWidget, problems: Sequence[Problem]) -> None:
    """Show these problems, errors first."""
    rows.clear()
    order = ("error", "warning", "info")
    for problem in sorted(problems, key=lambda one: order.index(one.severity)):
        reason = tr_core(problem.reason)
        item = QTreeWidgetItem([tr(_WORDS[problem.severity]), problem.file, reason])
        item.setIcon(0, icon(*_SIGNS[problem.severity]))
        for column in range(3):
            item.setTextAlignment(column, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
            item.setToolTip(column, plain_tip(reason))
        rows.addTopLevelItem(item)
    shown = min(len(problems), _MOST_ROWS) + 1
    rows.setMaximumHeight(rows.header().sizeHint().height() + shown * (rows.fontMetrics().height() + 12))
