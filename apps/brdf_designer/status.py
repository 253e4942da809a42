"""The status bar of the desk: flop, fit, gamut and link, as they are now."""

from __future__ import annotations

from collections.abc import Sequence

from brdf_qt.fit_error import fit_tips, is_large, marked
from brdf_qt.status_line import StatusLine

from brdf_designer.desk_state import Colours, FitState


class DeskStatus:
    """Writes what the desk knows into the cells of a status line."""

    def __init__(self, line: StatusLine) -> None:
        self._flop = line.cell(
            "Flop index",
            "Flop index 2.69 (L*15 − L*110)^1.11 / L*45^0.86: 0 for a solid colour, about 15 to 17 for a very "
            "high flop.",
        )
        self._fit = line.cell(
            "Fit",
            "The largest colour difference CIEDE2000, over the measured angles, between what is asked and what "
            "the fitted lobes give; and the time from the paint to its weights.",
        )
        self._gamut = line.cell("Gamut", "Whether this screen, taken as sRGB, can show the measured colours.")
        self._link = line.cell("Link", "Programs that follow this paint while it is edited.", right=True)
        self._fit_text = ""
        self.show_peers(())

    def show_colours(self, colours: Colours) -> None:
        """Show flop and gamut."""
        flop = colours.flop
        if flop is None:
            self._flop.set("Flop –", "The flop index needs readings at 15, 45 and 110°.")
        else:
            number = "–" if flop.value != flop.value else f"{flop.value:.1f}"
            text = f"Flop {number}" + (" ?" if flop.notice else "")
            notice = f"{flop.notice[:1].upper()}{flop.notice[1:]}." if flop.notice else None
            self._flop.set(text, notice, "warning" if flop.notice else "fresh")
        outside = [angle.text for angle in colours.angles if not angle.in_gamut]
        self._gamut.set(f"Outside sRGB: {', '.join(outside)}" if outside else "In sRGB")

    def show_fit(self, state: FitState) -> None:
        """Show the worst difference, the time, and whether the time limit came first."""
        limited, worst = ", time-limited" if state.time_limited else "", state.worst_delta_e
        text = f"Fit ΔE00 ≤ {_upward(worst)}, {state.milliseconds:.1f} ms{limited}"
        self._fit_text = marked(text, worst)
        large = is_large(worst)
        tip = fit_tips(worst, state.time_limited, state.exact_follows)
        self._fit.set(self._fit_text, tip, "warning" if large or state.time_limited else "fresh")

    def mark_stale(self) -> None:
        """Say that the fit is of an earlier paint."""
        self._fit.set(self._fit_text or "No fit", "This is of the last paint that can be.", "stale")

    def show_peers(self, roles: Sequence[str]) -> None:
        """Show who is linked."""
        text = "Linked: " + ", ".join(role.capitalize() for role in roles) if roles else "Not linked"
        self._link.set(text)


def _upward(value: float) -> str:
    """Two decimals, rounded up: the bound that is shown always holds."""
    return f"{-(-value * 100 // 1) / 100 if value > 1e-6 else 0.0:.2f}"
