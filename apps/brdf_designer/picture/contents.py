"""What the picture shows, and what is kept of it for the next start."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from brdf_qt.program.settings import settings

from brdf_suite.documents.store import view_from_json, view_to_json
from brdf_suite.documents.view import View
from brdf_suite.errors import SuiteError

if TYPE_CHECKING:
    from brdf_suite.pipeline.lobe_fit import LobeFit
    from brdf_suite.pipeline.scene import PreparedEnvironment
    from brdf_suite.surface.mesh import Mesh
    from brdf_suite.surface.occlusion.rays import BakedMesh

_KEY = "picture/view"


class PictureContents:
    """What is to be drawn: the newest light, form and fit; a new context draws the same anew."""

    def __init__(self) -> None:
        self.light: PreparedEnvironment | None = None
        self.form: Mesh | None = None
        self.baked: BakedMesh | None = None
        self.fit: LobeFit | None = None


def remember(view: View) -> None:
    """Keep a view for the next start."""
    settings().setValue(_KEY, json.dumps(view_to_json(view)))


def recall() -> View | None:
    """Return the view of the last time; None where there is none, or a damaged one."""
    try:
        return view_from_json(json.loads(str(settings().value(_KEY, ""))))
    except (SuiteError, ValueError, RecursionError):
        return None
