"""Step 1: the folder of photographs, the numbers of the rig, and what is wrong with it by file and reason."""

from __future__ import annotations

from collections.abc import Sequence

from brdf_qt.fields.form import Form
from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHeaderView, QTreeWidget, QTreeWidgetItem

from brdf_designer.acquire.pictures.view import PictureView
from brdf_designer.acquire.states import Problem, SessionState
from brdf_designer.acquire.step_page import AcquirePage, Facts, beside, button, wrapped

NUMBERS = (
    (
        "sphere.radius_m",
        mark("Sphere radius"),
        "mm",
        0.1,
        10_000.0,
        0.1,
        2,
        mark("Radius of the painted sphere"),
    ),
    (
        "camera.distance_m",
        mark("Camera distance"),
        "mm",
        10.0,
        100_000.0,
        1.0,
        1,
        mark("Horizontal distance from the centre of projection to the axis of the turntable"),
    ),
    (
        "camera.height_m",
        mark("Camera height"),
        "mm",
        -50_000.0,
        50_000.0,
        1.0,
        1,
        mark("Height above the centre of the sphere"),
    ),
    (
        "camera.tilt_deg",
        mark("Camera tilt"),
        "°",
        -89.0,
        89.0,
        0.1,
        2,
        mark("Tilt of the optical axis, positive upwards"),
    ),
    (
        "light.distance_m",
        mark("Lamp distance"),
        "mm",
        10.0,
        100_000.0,
        1.0,
        1,
        mark("Horizontal distance from the lamp to the axis of the turntable"),
    ),
    (
        "light.height_m",
        mark("Lamp height"),
        "mm",
        -50_000.0,
        50_000.0,
        1.0,
        1,
        mark("Height above the centre of the sphere"),
    ),
    (
        "light.angle_offset_deg",
        mark("Angle offset"),
        "°",
        -45.0,
        45.0,
        0.1,
        2,
        mark("Known zero error of the turntable; added to every stated angle"),
    ),
)
"""Key in the session, name, unit, range, step, decimals and explanation; millimetres stand for metres there."""
_SIGNS = {"error": "warning-octagon", "warning": "warning", "info": "info"}
_MOST_ROWS = 8
_WORDS = {"error": mark("Error"), "warning": mark("Warning"), "info": mark("Note")}


class SessionPage(AcquirePage):
    """The page of the session.

    Intents: ``open_requested()``, ``template_requested()``, ``check_requested()``, ``number_edited(key, value)`` in
    the unit of the field.
    """

    open_requested = Signal()
    template_requested = Signal()
    check_requested = Signal()
    number_edited = Signal(str, float)

    def __init__(self) -> None:
        super().__init__(
            "session",
            tr("Photographs of the painted sphere in a folder, described by a session.json."),
        )
        self.picture = PictureView(tr("A photograph of the session"))
        self.centre.addWidget(self.picture, 3)
        self.problems = problem_list(tr("Problems of the session"))
        self.verdict = wrapped("")
        self.centre.addWidget(self.verdict)
        self.centre.addWidget(self.problems, 2)
        self.open_button = button(tr("Open Folder…"), tr("Open a folder with a session.json"))
        self.template_button = button(
            tr("New Folder…"), tr("Create a folder with a session.json template for new photographs")
        )
        self.open_button.clicked.connect(lambda _=False: self.open_requested.emit())
        self.template_button.clicked.connect(lambda _=False: self.template_requested.emit())
        self.folder = wrapped("")
        self.folder.setAccessibleName(tr("Folder"))
        self.check_button = button(tr("Check Again"), tr("Check all photographs of the folder again"))
        self.check_button.clicked.connect(lambda _=False: self.check_requested.emit())
        self.add_part(
            "folder",
            tr("Folder"),
            self.folder,
            beside(self.open_button, self.template_button),
            self.check_button,
        )
        form = Form()
        self.fields: dict[str, NumberField] = {}
        for key, name, unit, low, high, step, decimals, tip in NUMBERS:
            field = NumberField(tr(name), unit, low, high, step, decimals, low)
            field.edited.connect(lambda value, key=key: self.number_edited.emit(key, value))
            form.add_row(tr(name), field, tr(tip))
            self.fields[key] = field
        self.kept = wrapped(tr("Changes are saved immediately. Undo: Ctrl+Z."))
        self.rig = self.add_part("rig", tr("Rig"), form, self.kept)
        self.facts = Facts(tr("Contents of the session"))
        self.about = self.add_part("photographs", tr("Photographs"), self.facts)
        self.show_session(None)

    def show_session(self, state: SessionState | None) -> None:
        """Show a session, or what to do where none is open."""
        there = state is not None
        for widget in (self.rig, self.about, self.check_button):
            widget.setVisible(there)
        if state is None:
            self.folder.setText(tr("No folder is open."))
            self.picture.show_empty(
                tr(
                    "Open a folder of photographs, or create a new one. Its session.json lists the "
                    "photographs to take."
                )
            )
            self.show_problems(None)
            return
        self.folder.setText(state.folder)
        for key, field in self.fields.items():
            field.set_value(state.values[key])
        first, last = state.angles_deg[0], state.angles_deg[-1]
        short, long = 1e3 * state.exposures_s[0], 1e3 * state.exposures_s[-1]
        rows = [
            (tr("Name"), state.name, tr("Name in session.json")),
            (
                tr("Positions"),
                tr("{count}, {first:g} to {last:g}°").format(
                    count=len(state.angles_deg), first=first, last=last
                ),
                tr("Lamp angles; 0° is at the camera"),
            ),
            (
                tr("Exposures"),
                tr("{count}, {short:g} to {long:g} ms").format(
                    count=len(state.exposures_s), short=short, long=long
                ),
                tr("Exposures of each position, shortest first"),
            ),
            (
                tr("Codes"),
                tr("{bits} bits, response: {response}").format(bits=state.bit_depth, response=state.response),
                tr("Encoding of the pixel values"),
            ),
        ]
        if state.date:
            rows.append((tr("Date"), state.date, tr("Name in session.json")))
        rows += [("", extra, "") for extra in state.extras]
        if state.notes:
            rows.append((tr("Notes"), state.notes, tr("Name in session.json")))
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
    made = QTreeWidget()
    made.setAccessibleName(name)
    made.setToolTip(tr("Problems found by the check: file, kind and reason"))
    made.setHeaderLabels([tr("Kind"), tr("File"), tr("Reason")])
    made.setRootIsDecorated(False)
    made.setWordWrap(True)
    made.setTextElideMode(Qt.TextElideMode.ElideNone)
    made.setUniformRowHeights(False)
    header = made.header()
    header.setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
    header.setSectionResizeMode(1, QHeaderView.ResizeMode.ResizeToContents)
    header.setSectionResizeMode(2, QHeaderView.ResizeMode.Stretch)
    header.setStretchLastSection(True)
    return made


def fill_problems(rows: QTreeWidget, problems: Sequence[Problem]) -> None:
    """Show these problems, errors first."""
    rows.clear()
    order = ("error", "warning", "info")
    for problem in sorted(problems, key=lambda one: order.index(one.severity)):
        item = QTreeWidgetItem([tr(_WORDS[problem.severity]), problem.file, problem.reason])
        item.setIcon(0, icon(_SIGNS[problem.severity]))
        for column in range(3):
            item.setTextAlignment(column, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
            item.setToolTip(column, plain_tip(problem.reason))
        rows.addTopLevelItem(item)
    shown = min(len(problems), _MOST_ROWS) + 1
    rows.setMaximumHeight(rows.header().sizeHint().height() + shown * (rows.fontMetrics().height() + 12))
