"""Palettes of other programs, and their colours in CMYK through the ICC profile of a press."""

from __future__ import annotations

from pathlib import Path

from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import tr

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Palette
from brdf_suite.errors import FileError
from brdf_suite.files.palettes import read_palette
from brdf_suite.files.palettes.cmyk_profile import profile_note, read_profile, seen_through

__all__ = ["profile_note", "read_palette", "read_profile", "seen_through", "show_through"]


def show_through(palette: Palette, profile: Path) -> tuple[Palette, int, tuple[str, ...]]:
    """Return a palette through a profile, of how many colours the look is the profile's, and notices.

    A profile that cannot be used is a notice.
    """
    if not any(isinstance(one.content, FlatColour) and one.content.model == "CMYK" for one in palette):
        return palette, 0, ()
    try:
        palette, count = seen_through(palette, {"": read_profile(profile)}, profile)
    except FileError as error:
        text = tr("The CMYK profile {name} cannot be used: {reason}.")
        return palette, 0, (text.format(name=profile.name, reason=tr_core(error.reason)),)
    return palette, count, (profile_note(count, profile.name),) if count else ()
