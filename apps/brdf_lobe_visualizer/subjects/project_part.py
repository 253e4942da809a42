"""A project in Lobe Visualizer: its paints and its measured source, each a reflectance."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from brdf_qt.documents.projects import OpenedProject

from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.sources_control import Sources
from brdf_suite.documents.project import Project
from brdf_suite.documents.store import AnyPaint
from brdf_suite.regular_files import is_file


class LobesProject:
    """Opens what a project has to look at, and gives back the paints that were added beside it."""

    def __init__(self, session: LobeSession, sources: Sources) -> None:
        self._session, self._sources = session, sources

    def show_project(self, opened: OpenedProject) -> None:
        """Show paints and source after what is there."""
        source = opened.project.source
        self._sources.open_many([*opened.paints, *([source] if source else [])])

    def gather_project(self, project: Project) -> Project:
        """Return the project with every paint that is shown, and with the first measured file where it names none."""
        paints: list[AnyPaint] = list(project.paints)
        source = project.source
        for subject in self._session.subjects:
            document = subject.material.document
            if document is not None and document not in paints:
                paints.append(document)
            elif document is None and not source and is_file(subject.material.origin):
                source = str(Path(subject.material.origin).absolute())
        return replace(project, paints=tuple(paints), source=source)

    def project_saved(self, opened: OpenedProject) -> None:
        """Nothing is edited here that could be unsaved."""
