"""Joins the legend to the session: its intents are edits of the session; each row has its error, from a thread."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from brdf_qt.fields.marks import Mark
from brdf_qt.fields.quiet import quieten
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.feature import Feature
from brdf_qt.program.translation import decimal, mark, tr
from brdf_qt.work.tasks import TaskRunner
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QColorDialog, QMenu

from brdf_lobe_visualizer.cuts.pens import line_icon
from brdf_lobe_visualizer.legend.legend import Legend, LegendRow
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.subjects import DASHES, LINE_COLOURS, Dash, PlottedMaterial
from brdf_lobe_visualizer.verdict import DELTA_E_LIMITS, RMS_LIMITS, verdict_of, words_of
from brdf_lobe_visualizer.window import LobeWindow
from brdf_suite.appearance.geometries import GEOMETRY_SETS
from brdf_suite.progress import Progress
from brdf_suite.reflectance.protocol import Reflectance

if TYPE_CHECKING:
    from brdf_suite.inspection.figures.figures import Errors

_PAUSE_MS = 60
"""A drag changes a paint sixty times a second; its error follows a few times."""


@dataclass(frozen=True)
class ShownError:
    """An error beside a subject: root mean square of the differences over that of the reference, and mean ΔE00.

    ``delta_e`` is over the angles of ASTM E2194 that both have; None where there is none.
    """

    errors: Errors
    delta_e: float | None


class LegendErrors(Feature, QObject):
    """Signals: ``changed()`` when an error is there, or none any more."""

    changed = Signal()

    def __init__(self, session: LobeSession, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._tasks = TaskRunner(self, threads=1)
        self._found: dict[str, ShownError] = {}
        self._working: set[str] = set()
        self._of: dict[str, tuple[Reflectance, Reflectance]] = {}
        self._pause = make_timer(self, self._look, _PAUSE_MS)
        session.subjects_changed.connect(self._touch)
        session.visibility_changed.connect(self._touch)
        session.options_changed.connect(self._touch)

    @property
    def is_idle(self) -> bool:
        return not self._tasks.busy and not self._pause.isActive()

    def error(self, key: str) -> ShownError | None:
        """Return the error of a subject against the reference; None where none was chosen, or it is not there yet."""
        return self._found.get(key)

    def is_stale(self, key: str) -> bool:
        """Whether the error is of the subject or the reference as they were before."""
        subject, reference = self._session.subject(key), self._session.reference
        if subject is None or reference is None or key not in self._found:
            return False
        return self._pause.isActive() or self._tasks.busy

    def close(self) -> None:
        self._pause.stop()
        self._tasks.stop()

    def _touch(self) -> None:
        # Not begun anew: a drag would put it off until its end.
        if not self._pause.isActive():
            self._pause.start()

    def _look(self) -> None:
        reference = self._session.reference
        wanted = {
            s.key: (self._session.target_of(reference), self._session.target_of(s))
            for s in self._session.subjects
            if reference is not None and s.key != reference.key
        }
        for key in set(self._of) - set(wanted):
            self._tasks.cancel(key)
            self._working.discard(key)
            del self._of[key]
            self._found.pop(key, None)
        for key, pair in wanted.items():
            before = self._of.get(key)
            same = before is not None and all(a is b for a, b in zip(before, pair, strict=True))
            # One that is in work is brought to its end, or a drag would show none.
            if not same and key not in self._working:
                self._of[key] = pair
                self._submit(key, pair)
        self.changed.emit()

    def _submit(self, key: str, pair: tuple[Reflectance, Reflectance]) -> None:
        self._working.add(key)

        def done(found: ShownError) -> None:
            self._working.discard(key)
            self._found[key] = found
            self._touch()
            self.changed.emit()

        def failed(_error: Exception) -> None:
            # The subject's own message reports the error already.
            self._working.discard(key)
            self._found.pop(key, None)
            self.changed.emit()

        self._tasks.submit(key, _error_of, pair, done, failed)


def _error_of(pair: tuple[Reflectance, Reflectance], _progress: Progress) -> ShownError:
    # Deferred: it brings the fits of undivided data, and nothing of it is needed before a reference is chosen.
    from brdf_suite.inspection.figures.figures import angle_readings, errors_between

    reference, other = pair
    errors = errors_between(reference, other)
    readings = angle_readings(other, None, reference, GEOMETRY_SETS["e2194"])
    differences = [r.delta_e_reference for r in readings if r.delta_e_reference is not None]
    return ShownError(errors, sum(differences) / len(differences) if differences else None)


LONGEST_TITLE = 200
_COLOUR_NAMES = (
    mark("Sky blue"),
    mark("Orange"),
    mark("Green"),
    mark("Pink"),
    mark("Vermilion"),
    mark("Blue"),
    mark("Yellow"),
)
_DASH_NAMES: dict[Dash, str] = {
    "solid": mark("Solid"),
    "dash": mark("Dashes"),
    "dot": mark("Dots"),
    "dash dot": mark("Dash and dot"),
    "long dash": mark("Long dashes"),
}


class LegendControl(QObject):
    """The legend, its commands in the menu Reflectance, and the errors beside the rows."""

    def __init__(self, session: LobeSession, window: LobeWindow) -> None:
        super().__init__(window)
        self._session, self._window = session, window
        self.errors = LegendErrors(session, self)
        self.legend = Legend(session)
        window.top_split.addWidget(self.legend)
        self._build_commands()
        legend = self.legend
        legend.renamed.connect(self.rename)
        legend.colour_requested.connect(lambda key: self._change_to_next(key, "colour", LINE_COLOURS))
        legend.dash_requested.connect(lambda key: self._change_to_next(key, "dash", DASHES))
        legend.menu_requested.connect(window.paint_menu.popup)
        for signal in (
            session.subjects_changed,
            session.front_changed,
            session.visibility_changed,
            self.errors.changed,
        ):
            signal.connect(self._show)
        self._show()

    def rename(self, key: str, title: str) -> None:
        """Give a subject another title; an empty one is not taken."""
        title = " ".join(title.split())[:LONGEST_TITLE]
        if title:
            self._session.change(key, title=title)
        self._show()

    def _change_to_next(self, key: str, name: str, known: Sequence[object]) -> None:
        subject = self._session.subject(key)
        if subject is not None:
            value = vars(subject)[name]
            place = known.index(value) if value in known else -1
            self._session.change(key, **{name: known[(place + 1) % len(known)]})

    def blink(self) -> None:
        """Show the front alone, then the reference alone, in turn."""
        front, other = self._session.front, self._session.reference
        if front is None or other is None or front is other:
            return
        shown = other if self._session.is_solo(front.key) else front
        for subject in self._session.subjects:
            self._session.set_solo(subject.key, subject is shown)

    def _show(self) -> None:
        front = self._session.front
        rows = [self._row(subject) for subject in self._session.subjects]
        self.legend.show_rows(rows, "" if front is None else front.key)
        for action in self._of_front:
            action.setEnabled(front is not None)
        self._solo.setChecked(front is not None and self._session.is_solo(front.key))
        self._shown.setChecked(front is not None and not self._session.is_hidden(front.key))
        self._reference.setChecked(front is not None and front is self._session.reference)
        self._blink.setEnabled(self._session.reference not in (None, front))

    def _row(self, subject: PlottedMaterial) -> LegendRow:
        session = self._session
        found = self.errors.error(subject.key)
        error, details = "", []
        verdict: Mark | None = None
        if found is not None:
            away, whole = (_percent(e.relative_rms) for e in (found.errors.away, found.errors.whole))
            error = f"({away})" if self.errors.is_stale(subject.key) else away
            text = tr(
                "Relative RMS difference: {rms} away from the mirror direction, {all} over all directions"
            )
            details.append(text.format(rms=away, all=whole))
            if found.delta_e is not None:
                text = tr("Mean ΔE00 at 15°, 45°, 110°: {value}")
                details.append(text.format(value=decimal(f"{found.delta_e:.2f}")))
                verdict = verdict_of(found.delta_e, DELTA_E_LIMITS)
            else:
                verdict = verdict_of(found.errors.away.relative_rms, RMS_LIMITS)
            details.append(words_of(verdict))
        if subject.fit is not None and subject.fit.worst_delta_e is not None:
            details.append(tr("Fit: worst ΔE00 {value}").format(value=f"{subject.fit.worst_delta_e:.2f}"))
        tip = "\n".join(
            [subject.title, tr_core(subject.material.origin), *map(tr_core, subject.notes), *details]
        )
        return LegendRow(
            subject.key,
            subject.title,
            subject.colour,
            subject.dash,
            shown=not session.is_hidden(subject.key),
            solo=session.is_solo(subject.key),
            reference=session.reference is subject,
            error=error,
            tip=tip,
            verdict=verdict,
        )

    def _build_commands(self) -> None:
        add, menu = self._window.add_command, "reflectance"
        self._shown = add(menu, mark("S&how"), "show", None)
        self._solo = add(menu, mark("So&lo"), "solo", None)
        tip = mark("Compute differences and errors against this reflectance")
        self._reference = add(menu, mark("Set as &Reference"), "reference", None, tip=tip)
        session = self._session
        for action, act in (
            (self._shown, lambda key, on: session.set_hidden(key, not on)),
            (self._solo, session.set_solo),
            (self._reference, lambda key, on: session.set_reference(key if on else None)),
        ):
            action.setCheckable(True)
            # Not toggled: the ticks also follow the front, which is no command.
            action.triggered.connect(lambda on, act=act: self._for_front(lambda key: act(key, on)))
        rename = add(menu, mark("Re&name"), None, lambda: self._for_front(self.legend.edit_title))
        self._build_line_menu()
        up = add(menu, mark("Move &Up"), "move_up", lambda: self._move(-1))
        down = add(menu, mark("Move &Down"), "move_down", lambda: self._move(1))
        gone = add(menu, mark("Re&move"), "remove", lambda: self._for_front(self._session.remove), icon="x")
        self._of_front = [
            self._shown,
            self._solo,
            self._reference,
            rename,
            self._line.menuAction(),
            up,
            down,
            gone,
        ]
        self._window.paint_menu.addSeparator()
        add(menu, mark("Show &All"), "show_all", self._session.show_all, icon="eye")
        add(menu, mark("Remove All &Others"), None, lambda: self._for_front(self._remove_others))
        add(menu, mark("Ne&xt Reflectance"), "next_tab", lambda: self._step(1))
        add(menu, mark("Pre&vious Reflectance"), "previous_tab", lambda: self._step(-1))
        tip = mark("Show the selected reflectance and the reference alternately")
        self._blink = add(menu, mark("Al&ternate with Reference"), "blink", self.blink, tip=tip)

    def _build_line_menu(self) -> None:
        self._line = QMenu(tr("L&ine"), self._window.paint_menu)
        self._window.paint_menu.addMenu(self._line)
        for name, colour in zip(_COLOUR_NAMES, LINE_COLOURS, strict=True):
            action = self._line.addAction(line_icon(colour, "solid"), tr(name))
            action.triggered.connect(
                lambda _=False, colour=colour: self._for_front(
                    lambda key: self._session.change(key, colour=colour)
                )
            )
        self._line.addAction(tr("Other Colour…"), lambda: self._for_front(self.choose_colour))
        self._line.addSeparator()
        for dash, title in _DASH_NAMES.items():
            action = self._line.addAction(line_icon((0.5, 0.5, 0.5), dash), tr(title))
            action.triggered.connect(
                lambda _=False, dash=dash: self._for_front(lambda key: self._session.change(key, dash=dash))
            )
        self._line.addSeparator()
        self._line.addAction(tr("Reset All Lines"), self.reset_lines)

    def reset_lines(self) -> None:
        count = len(LINE_COLOURS)
        lines = [
            (LINE_COLOURS[k % count], DASHES[(k + k // count) % len(DASHES)])
            for k in range(len(self._session.subjects))
        ]
        subjects = zip(self._session.subjects, lines, strict=True)
        self._session.set_subjects([replace(s, colour=colour, dash=dash) for s, (colour, dash) in subjects])

    def choose_colour(self, key: str) -> None:
        subject = self._session.subject(key)
        if subject is None:
            return
        change = self._session.change
        dialog = QColorDialog(QColor.fromRgbF(*subject.colour), self._window)
        dialog.setOption(QColorDialog.ColorDialogOption.DontUseNativeDialog)
        dialog.currentColorChanged.connect(lambda c: change(key, colour=(c.redF(), c.greenF(), c.blueF())))
        dialog.rejected.connect(lambda: change(key, colour=subject.colour))
        dialog.finished.connect(dialog.deleteLater)
        quieten(dialog)
        dialog.open()

    def _remove_others(self, key: str) -> None:
        self._session.set_subjects([s for s in self._session.subjects if s.key == key])

    def _for_front(self, act: Callable[[str], object]) -> None:
        front = self._session.front
        if front is not None:
            act(front.key)

    def _move(self, by: int) -> None:
        keys = [s.key for s in self._session.subjects]
        self._for_front(lambda key: self._session.move(key, keys.index(key) + by))

    def _step(self, by: int) -> None:
        keys = [s.key for s in self._session.subjects]
        self._for_front(lambda key: self._session.set_front(keys[(keys.index(key) + by) % len(keys)]))


def _percent(share: float) -> str:
    """Return a share with three digits and no exponent."""
    return decimal(f"{100.0 * share:.3g} %" if share < 10.0 else f"{100.0 * share:.0f} %")
