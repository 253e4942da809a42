"""The status bar of Designer: flop asked and reached, what the fit gives, gamut and link, as they are now."""

from __future__ import annotations

from collections.abc import Sequence

from brdf_qt.fields.marks import Mark
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.suite import connected_words
from brdf_qt.program.translation import decimal, mark, tr
from brdf_qt.window.status_line import StatusLine
from brdf_qt.work.fit_error import fit_mark, fit_tips

from brdf_designer.colour.patches import one_decimal
from brdf_designer.session.state import FLOP_ANGLES_DEG, AngleColour, Colours, Curves, FitState
from brdf_suite.appearance.flop.travel import FlopIndex, flop_index
from brdf_suite.documents.paint import Lab


class PaintStatus:
    """Writes what is known of the paint into the cells of a status line."""

    def __init__(self, line: StatusLine) -> None:
        self._flop = line.cell(
            mark("Flop index"),
            tr(
                "Flop: darkening of the paint from face to flop, as the index\n2.69 (L*15 − "
                "L*110)^1.11 / L*45^0.86: 0 for a solid colour, about 15 to 17 for a very high "
                "flop.\nFirst the target, then the value achieved by the fitted lobes."
            ),
        )
        self._fit = line.cell(
            mark("Fit"),
            tr(
                "Largest colour difference CIEDE2000 between the target and the fitted lobes, "
                "at the measured angles and between them; then the time of the fit, and "
                "whether the fit is exact or was stopped by the time limit."
            ),
            elastic=True,
        )
        self._gamut = line.cell(
            mark("Gamut"),
            tr("Whether this screen, taken as sRGB, can show the measured colours."),
            elastic=True,
        )
        self._model = line.cell(
            mark("Model"),
            tr("How colours between the measured angles are found, where that has been changed."),
        )
        self._link = line.cell(mark("Link"), tr("Programs that follow the edits of this paint."), right=True)
        self._model.reserve(tr("Model"))
        self._fit.reserve(_fit_words("88.88", "88.88", "888.8", tr("time-limited")))
        self._gamut.reserve(tr("Outside sRGB: {angles}").format(angles="15°, 45°, 110°"))
        self._colours: Colours | None = None
        self._fitted: tuple[Colours | None, FitState] | None = None
        self._fit_text = ""
        self.show_peers(())

    def show_colours(self, colours: Colours) -> None:
        """Show the gamut; the flop, asked and reached, comes with the fit, or alone where there is none."""
        self._colours = colours
        outside = [angle.text for angle in colours.angles if not angle.in_gamut]
        self._gamut.set(
            tr("Outside sRGB: {angles}").format(angles=", ".join(outside)) if outside else tr("In sRGB"),
            mark=Mark.OUTSIDE if outside else None,
        )

    def show_model(self, rule: str, *, changed: bool) -> None:
        """Show the rule between the angles where it is another than that of the paint as it was opened."""
        tip = tr("Model changed: {rule}").format(rule=rule) if changed else None
        self._model.set(tr("Model") if changed else "", tip, mark=Mark.CHANGED if changed else None)

    def show_fit(self, state: FitState) -> None:
        """Show the flop that is reached; what the fit gives is shown with the fit between the angles."""
        self._fitted = (self._colours, state)
        if self._colours is not None:
            self._show_flop(self._colours.flop, _reached_flop(self._colours, state))

    def show_curves(self, curves: Curves) -> None:
        """Show the worst differences, the time, and whether the time limit came first; after :meth:`show_fit`."""
        if self._fitted is None:
            return
        colours, state = self._fitted
        worst = state.worst_delta_e
        text = _fit_words(
            _upward(worst),
            _upward(curves.between_delta_e),
            decimal(f"{state.milliseconds:.1f}"),
            tr("time-limited") if state.time_limited else tr("exact"),
        )
        self._fit_text = text
        sign = fit_mark(max(worst, curves.between_delta_e), state.time_limited)
        tip = fit_tips(worst, state.time_limited, state.exact_follows)
        rows = [] if colours is None else [_row(angle, state) for angle in colours.angles]
        text = "\n".join((*rows, tip) if tip else rows)
        self._fit.set(self._fit_text, text, "warning" if sign else "fresh", sign)

    def mark_stale(self) -> None:
        """Say that the fit is of an earlier paint."""
        if self._colours is not None:
            self._show_flop(self._colours.flop, None)
        self._fit.set(
            self._fit_text or tr("No fit"), tr("These values are those of the last possible paint."), "stale"
        )

    def show_peers(self, roles: Sequence[str]) -> None:
        """Show who is linked."""
        self._link.set(connected_words(roles))

    def _show_flop(self, asked: FlopIndex | None, reached: FlopIndex | None) -> None:
        if asked is None:
            self._flop.set(tr("Flop –"), tr("The flop index needs readings at 15, 45 and 110°."))
            return
        text = tr("Flop {target}").format(target=_one_decimal(asked.value))
        if reached is not None:
            text = tr("{flop}, achieved {achieved}").format(flop=text, achieved=_one_decimal(reached.value))
        notice = tr_core(f"{asked.notice[:1].upper()}{asked.notice[1:]}.") if asked.notice else None
        self._flop.set(f"{text} ?" if asked.notice else text, notice, "warning" if asked.notice else "fresh")


def _reached_flop(colours: Colours, state: FitState) -> FlopIndex | None:
    given = {angle.aspecular_deg: state.given[angle.index].lab[0] for angle in reversed(colours.angles)}
    if any(angle not in given for angle in FLOP_ANGLES_DEG):
        return None
    return flop_index(*(given[angle] for angle in FLOP_ANGLES_DEG))


def _row(angle: AngleColour, state: FitState) -> str:
    return tr("{angle}: target {target}, fit {fit}, ΔE00 {difference}").format(
        angle=angle.text,
        target=_lab(angle.lab),
        fit=_lab(state.given[angle.index].lab),
        difference=decimal(f"{state.delta_e[angle.index]:.2f}"),
    )


def _fit_words(worst: str, between: str, time: str, kind: str) -> str:
    return tr("Fit ΔE00 ≤ {worst}, between ≤ {between}, {time} ms, {kind}").format(
        worst=worst, between=between, time=time, kind=kind
    )


def _lab(lab: Lab) -> str:
    return " / ".join(map(one_decimal, lab))


def _one_decimal(value: float) -> str:
    return "–" if value != value else decimal(f"{value:.1f}")


def _upward(value: float) -> str:
    """Two decimals, rounded up: the bound that is shown always holds."""
    return decimal(f"{-(-value * 100 // 1) / 100 if value > 1e-6 else 0.0:.2f}")
