"""The parts of the program that come as commands, sections or panels of their own, in the order of the menus."""

from __future__ import annotations

from collections.abc import Callable

from brdf_color_swatch.export.part import ExportPart
from brdf_color_swatch.export.sheet_part import SheetPart
from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.features.compare_part import ComparePart
from brdf_color_swatch.features.drop_part import DropPart
from brdf_color_swatch.features.edit_part import EditPart
from brdf_color_swatch.features.group_part import GroupPart
from brdf_color_swatch.features.link_part import LinkPart
from brdf_color_swatch.features.near_part import NearPart
from brdf_color_swatch.features.view_part import ViewPart
from brdf_color_swatch.library.file_part import FilePart
from brdf_color_swatch.library.outside_part import OutsidePart
from brdf_color_swatch.map.part import MapPart
from brdf_color_swatch.pictures.part import PicturePart
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow

PARTS: tuple[Callable[[PaletteSession, SwatchWindow], SwatchFeature], ...] = (
    FilePart,
    ExportPart,
    SheetPart,
    EditPart,
    DropPart,
    GroupPart,
    ViewPart,
    NearPart,
    ComparePart,
    LinkPart,
    MapPart,
    OutsidePart,
    PicturePart,
)
"""What makes each part: called with session and window, it adds itself to the window and listens to the session."""


def build_parts(session: PaletteSession, window: SwatchWindow) -> list[SwatchFeature]:
    """Make every part and return them; their owner keeps them."""
    return [part(session, window) for part in PARTS]
