"""Step 6: all photographs to one table: how far it is, what of it is covered so far, and what could not be used."""

from __future__ import annotations

from collections.abc import Sequence

from brdf_qt.fields.form import Form
from brdf_qt.fields.number import NumberField
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import tr
from PySide6.QtCore import Signal

from brdf_designer.acquire.plots.map_plot import MapPlot
from brdf_designer.acquire.reconstruction.coverage_page import coverage_map
from brdf_designer.acquire.session.page import fill_problems, problem_list
from brdf_designer.acquire.states import CoverageState, Problem
from brdf_designer.acquire.step_page import AcquirePage, Facts
from brdf_designer.window.widgets import button, make_row, wrapped


class ReconstructionPage(AcquirePage):
    """The page of the reconstruction.

    Intents: ``start_requested()``, ``again_requested()``, ``grazing_edited(degrees)``. How far it is, and the button
    to stop it, are in the window's strip of progress, as those of every step are.
    """

    start_requested = Signal()
    again_requested = Signal()
    grazing_edited = Signal(float)

    def __init__(self) -> None:
        super().__init__(
            "reconstruction",
            tr(
                "Combines all photographs into one table of the reflectance. It can be stopped "
                "and resumed; finished positions are kept."
            ),
        )
        self.progress_text = wrapped()
        self.map = MapPlot(tr("Coverage so far"))
        self.problems = problem_list(tr("Skipped positions"))
        self.centre.addWidget(self.progress_text)
        self.centre.addWidget(self.map, 3)
        self.centre.addWidget(self.problems, 1)
        tip = tr("Combine all photographs into a table of the reflectance")
        self.start = button(tr("Start"), tip, self.start_requested.emit)
        tip = tr("Discard the finished positions and start with the first one")
        self.again = button(tr("Start Over"), tip, self.again_requested.emit)
        form = Form()
        self.grazing = NumberField(tr("Grazing cut-off"), "°", 45.0, 89.0, 1.0, 0, 80.0)
        self.grazing.edited.connect(self.grazing_edited)
        form.add_row(
            tr("Grazing cut-off"),
            self.grazing,
            tr("Largest angle of light or view from the normal; pixels beyond it are skipped"),
        )
        self.add_part("run", tr("Reconstruction"), make_row(self.start, self.again), form)
        self.facts = Facts(tr("Progress"))
        self.add_part("done", tr("Done"), self.facts)
        self.show_progress("", running=False)
        self.show_done(0, 0, ())

    def show_progress(self, text: str, *, running: bool) -> None:
        """Say what is being done, and that nothing else can be begun while it is ``running``."""
        self.progress_text.setText(tr_core(text) or tr("Not started."))
        self.start.setEnabled(not running)
        self.again.setEnabled(not running)
        self.grazing.setEnabled(not running)

    def show_done(self, done: int, total: int, failed: Sequence[Problem]) -> None:
        """Show how many positions are done, and which could not be used."""
        self.start.setText(tr("Resume") if 0 < done < total else tr("Start"))
        counts = tr("{done} of {total}").format(done=done, total=total)
        tip = tr("Lamp positions that could not be used; the list gives the reasons")
        self.facts.show_rows(
            (
                (tr("Positions"), counts, tr("Lamp positions included in the table")),
                (tr("Excluded"), str(len(failed)), tip),
            )
        )
        fill_problems(self.problems, failed)
        self.problems.setVisible(bool(failed))

    def show_partial(self, state: CoverageState | None) -> None:
        """Show what is covered so far."""
        if state is None:
            self.map.clear(tr("The map is updated after each position."))
        else:
            self.map.show_map(coverage_map(state, "share"))
