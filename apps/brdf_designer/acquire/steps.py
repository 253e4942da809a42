"""The steps of the assistant, in their order."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from brdf_qt.program.translation import mark

StepState = Literal["todo", "running", "done", "warning"]
SIGNS: dict[StepState, str] = {
    "todo": "circle",
    "running": "hourglass",
    "done": "check-circle",
    "warning": "warning",
}
STATE_WORDS: dict[StepState, str] = {
    "todo": mark("pending"),
    "running": mark("running"),
    "done": mark("done"),
    "warning": mark("check result"),
}


@dataclass(frozen=True)
class AcquireStep:
    """A step by its key and title."""

    key: str
    title: str


STEPS = (
    AcquireStep("session", mark("Session")),
    AcquireStep("exposures", mark("Exposures")),
    AcquireStep("response", mark("Response")),
    AcquireStep("geometry", mark("Geometry")),
    AcquireStep("mask", mark("Mask")),
    AcquireStep("reconstruction", mark("Reconstruction")),
    AcquireStep("coverage", mark("Coverage")),
    AcquireStep("fit", mark("Fit")),
)
KEYS = tuple(step.key for step in STEPS)
