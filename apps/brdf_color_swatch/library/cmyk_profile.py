"""The ICC profile of a press through which colours in CMYK are shown: chosen, remembered, applied as one step."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.message_bar import Message

from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.library.library import OpenPalette
from brdf_color_swatch.library.loading import (
    PROFILE_KEY,
    foreign_palettes,
    read_palette_file,
    remembered_profile,
)
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.documents.palette import Palette
from brdf_suite.palettes.merge import merge
from brdf_suite.progress import Progress, report

_KEY = "cmyk profile"


@dataclass(frozen=True, eq=False)
class _Request:
    """A palette, and the file of another program that it was imported from, with what that held."""

    palette: Palette
    base: Palette
    origin: Path | None


@dataclass(frozen=True, eq=False)
class _Seen:
    """A palette through the profile, what its file holds so, and of how many colours the look is the profile's."""

    palette: Palette
    base: Palette
    count: int


class CmykProfile(SwatchFeature):
    """The commands that choose a profile and forget it; imported palettes are read again, their edits stay."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        super().__init__(session, window)
        window.menus["file"].addSeparator()
        self._choose = window.add_command(
            "file", mark("Choose CM&YK Profile…"), None, self.ask, "cmyk_profile",
            tip=mark("Show the CMYK colours of this palette, and of those opened later, through an ICC profile"),
        )  # fmt: skip
        self._forget = window.add_command(
            "file", mark("Forget CMYK Profile"), None, self.forget, "forget_cmyk_profile",
            tip=mark("Show the CMYK colours of palettes opened later without a profile"),
        )  # fmt: skip
        session.library.profile_requested.connect(self.ask_for)
        self._enable_always()

    def ask(self) -> None:
        """Ask for a profile for the palette in front."""
        self.ask_for(self._session.state.scope.palette)

    def ask_for(self, key: str) -> None:
        """Ask for a profile, show a palette through it, and remember it for those that are opened later."""
        if self._session.library.palette(key) is None:
            return  # closed since it was offered
        known = remembered_profile()
        folder = Path.home() if known is None else known.parent
        filters = tr("ICC profiles") + " (*.icc *.icm *.ICC *.ICM);;" + tr("All files (*)")
        path = self._session.library.dialogs.open_path(folder, filters)
        if path is not None:
            self._begin(key, path.absolute())

    def forget(self) -> None:
        """Show palettes that are opened later without a profile; what is open stays as it is."""
        settings().remove(PROFILE_KEY)
        self._enable()

    def _begin(self, key: str, profile: Path) -> None:
        library = self._session.library
        item = library.item(key)
        if item is None or item.palette is None:
            return
        opened = item.palette
        mine = opened.store.value
        request = _Request(mine, opened.base, opened.origin)

        def done(seen: _Seen) -> None:
            now = library.item(key)
            if now is None or now.palette is not opened:
                return
            if opened.store.value is not mine:
                # An edit came meanwhile, and stays.
                self._begin(key, profile)
                return
            self._take(key, opened, seen, profile)

        self._session.reading.begin(
            profile,
            lambda path, progress: _see(request, path, progress),
            done,
            lambda error: library.fails(error, _KEY, tr("The palette is unchanged. Choose another profile.")),
        )

    def _take(self, key: str, opened: OpenPalette, seen: _Seen, profile: Path) -> None:
        library = self._session.library
        settings().setValue(PROFILE_KEY, str(profile))
        self._enable()
        library.settled.emit(f"open {key}")
        was_clean = opened.store.is_clean
        library.history.apply(tr("Choose CMYK profile"), [(opened.store, seen.palette)])
        if opened.origin is not None:
            opened.base = seen.base
            if was_clean and seen.palette == seen.base:
                # As after an import: it would be read in the same way again.
                opened.store.stack.setClean()
        text = tr_core(foreign_palettes().profile_note(seen.count, profile.name))
        if not seen.count:
            text = tr("All CMYK colours of this palette have a look of their own, which they keep.")
        self._window.show_message(Message(_KEY, text))

    def _enable(self) -> None:
        rows = self._session.library.rows(self._session.state.scope.palette)
        self._choose.setEnabled(bool(rows.inks) and not self._session.is_read_only)
        self._forget.setEnabled(remembered_profile() is not None)


def _see(request: _Request, profile: Path, progress: Progress) -> _Seen:
    report(progress, 0.0, profile.name)
    foreign = foreign_palettes()
    content = foreign.read_profile(profile)
    if request.origin is None:
        palette, count = foreign.seen_through(request.palette, {"": content}, profile)
        return _Seen(palette, request.base, count)
    read = read_palette_file(request.origin, progress, profile)
    merged = merge(request.base, request.palette, read.palette).palette
    # What was pasted or dropped into it is not in its file.
    palette, more = foreign.seen_through(merged, {"": content}, profile)
    return _Seen(palette, read.palette, read.seen + more)
