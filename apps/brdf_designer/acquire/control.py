"""File ▸ Acquire…: the window of the assistant and its parts, made when it is first asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING

from brdf_qt.program.feature import Feature
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QObject

from brdf_designer.session.paint_session import PaintSession
from brdf_designer.window.window import DesignerWindow

if TYPE_CHECKING:
    from brdf_designer.acquire.assistant import Assistant


class AcquireControl(Feature, QObject):
    """Opens the assistant; ``close`` ends what runs. What is done of a reconstruction is kept in its folder."""

    def __init__(self, paint_session: PaintSession, window: DesignerWindow) -> None:
        super().__init__(window)
        self._paint_session, self._window = paint_session, window
        self.assistant: Assistant | None = None
        self.action = window.add_command(
            "file",
            tr("Ac&quire…"),
            "acquire",
            self.open,
            "acquire",
            tip=tr("From photographs of a painted sphere to a paint, step by step"),
        )

        window.add_command(
            "file",
            mark("Try a S&imulated Acquisition"),
            None,
            self.open_sample,
            "acquire_sample",
            tip=mark("All steps with photographs of a simulated sphere; about half a minute"),
        )

    def open_sample(self) -> None:
        """Show the assistant, which takes all steps with photographs of a simulated rig."""
        self.open().try_sample()

    def open(self) -> Assistant:
        """Show the assistant."""
        if self.assistant is None:
            # The pages and their plots take a moment that no start has to pay.
            from brdf_designer.acquire.assistant import Assistant

            self.assistant = Assistant(self._paint_session, self._window)
        self.assistant.window.bring()
        return self.assistant

    @property
    def is_idle(self) -> bool:
        """Whether no work is pending."""
        return self.assistant is None or self.assistant.bench.is_quiet

    def close(self) -> None:
        """End the threads; what was painted or typed and is not yet written is written first."""
        if self.assistant is not None:
            self.assistant.close()
