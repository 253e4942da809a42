"""The open studio as a document: what a new one and a new lamp start from, how it is read and written."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

from brdf_qt.documents.files import DocumentFiles, DocumentFormat
from brdf_qt.program.translation import mark

from brdf_suite.documents.studio import (
    STUDIO_ENDING,
    Backdrop,
    LightDocument,
    Sky,
    Studio,
    StudioLamp,
    light_from_json,
    light_to_json,
    load_light,
    save_light,
)
from brdf_suite.lighting.procedural.studio import BOOTH, EXAMPLE

TEMPLATES: Mapping[str, tuple[str, LightDocument]] = MappingProxyType(
    {
        "three": (mark("Box, strip and ring"), EXAMPLE),
        "tunnel": (
            mark("Light tunnel"),
            Studio(
                mark("Light tunnel"),
                backdrop=Backdrop(luminance=0.08),
                lamps=tuple(
                    StudioLamp(
                        "strip", (x, y, 0.0), (9.0, 0.25), roll_deg=90.0, luminance=8.0, softness_m=0.03
                    )
                    for x, y in ((-2.6, 0.8), (-1.8, 2.2), (0.0, 2.8), (1.8, 2.2), (2.6, 0.8))
                ),
            ),
        ),
        "booth": (mark("Light booth"), dataclasses.replace(BOOTH, name=mark("My booth"))),
        "empty": (
            mark("One box above"),
            Studio(
                mark("My studio"),
                backdrop=Backdrop(luminance=0.15),
                lamps=(StudioLamp("box", (0.0, 3.0, 0.5), (2.5, 2.5), luminance=5.0, softness_m=0.2),),
            ),
        ),
        "sky": (mark("Sky with sun"), Sky(mark("My sky"))),
    }
)
"""Title and document by key, in the order of the menu."""

NEW_LAMPS: Mapping[str, StudioLamp] = MappingProxyType(
    {
        "box": StudioLamp("box", (1.8, 1.6, 1.8), (1.2, 1.2), softness_m=0.1),
        "strip": StudioLamp("strip", (-2.0, 1.2, 1.6), (2.0, 0.25), roll_deg=90.0, luminance=8.0),
        "ring": StudioLamp("ring", (0.0, 1.0, 2.8), (1.0, 0.12), luminance=8.0, softness_m=0.02),
    }
)
"""What is added, by its shape."""


FORMAT: DocumentFormat[LightDocument] = DocumentFormat(
    kind="studio",
    ending=STUDIO_ENDING,
    new=lambda: TEMPLATES["empty"][1],
    load=load_light,
    save=save_light,
    to_json=light_to_json,
    from_json=light_from_json,
    name_of=lambda light: light.name,
)


class StudioFiles(DocumentFiles[LightDocument]):
    """Files of studios. Which were opened last is the Viewer's list of environments, so none is kept here."""

    def recent(self) -> list[Path]:
        return []

    def remember(self, path: Path) -> None:
        pass
