"""The session that every part of the window shares: subjects, light and options, with signals for changes.

A part is made with ``(session, window)``, adds its widgets to the window and listens to the session.
No part knows another.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject, Signal

from brdf_lobe_visualizer.options import INCIDENCE_DEG, MOST_THETA_DEG, Options
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial
from brdf_suite.arrays import Floats
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.geometry.directions import spherical
from brdf_suite.inspection.lobe_surface.parts import FitPart
from brdf_suite.reflectance.designed.layers import split_layers
from brdf_suite.reflectance.protocol import Reflectance

if TYPE_CHECKING:
    from brdf_qt.window.main_window import SuiteWindow

    from brdf_suite.fitting.lobes.weights import LobeWeights


class LobeSession(QObject):
    """All subjects, in the order of the legend, and the options that the views share.

    Signals:

    - ``subjects_changed()``: subjects came, went, changed their place, or one is another now (its reflectance, fit,
      title or line).
    - ``front_changed()``: another subject is the one that is selected. Changes of the subject itself emit
      ``subjects_changed``.
    - ``visibility_changed()``: others are visible, by show or solo, or the one that differences are taken against
      is another.
    - ``incidence_changed(theta_deg, phi_deg)``: the light stands elsewhere.
    - ``options_changed()``: channel, radius, cosine, what is shown, or the lobes that are switched on.
    - ``view_reset()``: the view of a first start is restored; a feature resets what only it knows of it.
    """

    subjects_changed = Signal()
    front_changed = Signal()
    visibility_changed = Signal()
    incidence_changed = Signal(float, float)
    options_changed = Signal()
    view_reset = Signal()

    def __init__(self, messages: SuiteWindow, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.messages = messages
        self.changes = (
            self.subjects_changed,
            self.front_changed,
            self.visibility_changed,
            self.incidence_changed,
            self.options_changed,
        )
        """What a view that shows all of it listens to."""
        self.tasks = TaskRunner(self)
        self.subjects: tuple[PlottedMaterial, ...] = ()
        """All of them, in the order of the legend; there may be none."""
        self._front = ""
        self._reference_key = ""
        self._hidden: frozenset[str] = frozenset()
        self._solo: frozenset[str] = frozenset()
        self.incidence = INCIDENCE_DEG
        """Polar angle (0 to 89.9) and azimuth (above -180, to 180) of the plane of incidence, degrees.

        At azimuth 0 the light stands on the -x side and its mirror direction leans to +x, as in
        :func:`brdf_suite.geometry.directions.illumination`.
        """
        self.options = Options()
        self.fitting = FitSettings()
        """How lobes are fitted to the subjects."""
        self._bases: dict[str, tuple[Reflectance, Reflectance]] = {}

    @property
    def visible(self) -> tuple[PlottedMaterial, ...]:
        """Those that are shown: where any is solo those, else all that are not hidden."""
        shown = self._solo or {s.key for s in self.subjects} - self._hidden
        return tuple(s for s in self.subjects if s.key in shown)

    @property
    def front(self) -> PlottedMaterial | None:
        """The one that is selected; None only where there is none."""
        return self.subject(self._front)

    @property
    def reference(self) -> PlottedMaterial | None:
        """The one that differences are taken against: the reference; None where none was chosen."""
        return self.subject(self._reference_key)

    def subject(self, key: str) -> PlottedMaterial | None:
        return next((s for s in self.subjects if s.key == key), None)

    def set_subjects(self, subjects: Sequence[PlottedMaterial]) -> None:
        """Put these in the place of all; what was said of keys that stay (front, hidden, solo) stays."""
        before_front, before = self._front, (self._hidden, self._solo, self._reference_key)
        self.subjects = tuple(subjects)
        keys = frozenset(s.key for s in self.subjects)
        if self._front not in keys:
            self._front = self.subjects[0].key if self.subjects else ""
        if self._reference_key not in keys:
            self._reference_key = ""
        self._bases = {key: kept for key, kept in self._bases.items() if key in keys}
        self._hidden &= keys
        self._solo &= keys
        self.subjects_changed.emit()
        if self._front != before_front:
            self.front_changed.emit()
        if (self._hidden, self._solo, self._reference_key) != before:
            self.visibility_changed.emit()

    def add(self, subject: PlottedMaterial) -> None:
        """Put a subject at the end, or in the place of the one with its key."""
        known = {s.key: s for s in self.subjects}
        self.set_subjects(tuple((known | {subject.key: subject}).values()))

    def change(self, key: str, **fields: Any) -> None:
        """Give the subject of that key other fields; nothing where it has gone."""
        subject = self.subject(key)
        if subject is not None:
            self.add(replace(subject, **fields))

    def remove(self, key: str) -> None:
        """Take a subject away; its neighbour becomes the front where it was that."""
        keys = [s.key for s in self.subjects]
        if key not in keys:
            return
        place = keys.index(key)
        rest = [s for s in self.subjects if s.key != key]
        if key == self._front and rest:
            self._front = rest[min(place, len(rest) - 1)].key
            self.set_subjects(rest)
            self.front_changed.emit()
        else:
            self.set_subjects(rest)

    def move(self, key: str, place: int) -> None:
        """Put a subject at ``place``, 0 the first, of the legend's order."""
        subject = self.subject(key)
        if subject is not None:
            rest = [s for s in self.subjects if s.key != key]
            rest.insert(max(place, 0), subject)
            if tuple(rest) != self.subjects:
                self.set_subjects(rest)

    def set_front(self, key: str) -> None:
        if key != self._front and self.subject(key) is not None:
            self._front = key
            self.front_changed.emit()

    def set_reference(self, key: str | None) -> None:
        """Take differences against the subject of that key, or against none."""
        wanted = key if key and self.subject(key) is not None else ""
        if wanted != self._reference_key:
            self._reference_key = wanted
            self.visibility_changed.emit()

    def is_hidden(self, key: str) -> bool:
        return key in self._hidden

    def is_solo(self, key: str) -> bool:
        return key in self._solo

    def set_hidden(self, key: str, hidden: bool) -> None:
        self._set_seen(self._hidden | {key} if hidden else self._hidden - {key}, self._solo)

    def set_solo(self, key: str, solo: bool) -> None:
        """Show a subject alone, with the others that are so, or no more."""
        self._set_seen(self._hidden, self._solo | {key} if solo else self._solo - {key})

    def show_all(self) -> None:
        self._set_seen(frozenset(), frozenset())

    @property
    def light(self) -> Floats:
        """The unit direction (3,) to the light."""
        return light_at(*self.incidence)

    def set_incidence(self, theta_deg: float, phi_deg: float) -> None:
        """Put the light there; angles are brought into their range."""
        theta = min(max(float(theta_deg), 0.0), MOST_THETA_DEG)
        # The sum takes the sign of a zero away.
        phi = 0.0 - ((180.0 - float(phi_deg)) % 360.0 - 180.0)
        if (theta, phi) != self.incidence:
            self.incidence = (theta, phi)
            self.incidence_changed.emit(theta, phi)

    def reset_incidence(self) -> None:
        self.set_incidence(*INCIDENCE_DEG)

    def set_options(self, **fields: Any) -> None:
        """Set options by name: ``channel``, ``radius``, ``cosine``, ``shown``, ``lobes_off``, ``gloss``."""
        options = replace(self.options, **fields)
        if options != self.options:
            self.options = options
            self.options_changed.emit()

    def reset_options(self, *names: str) -> None:
        """Set options back, all where none is named."""
        plain = Options()
        self.set_options(**{name: getattr(plain, name) for name in names or vars(plain)})

    def reset_view(self) -> None:
        self.reset_options()
        self.reset_incidence()
        self.view_reset.emit()

    def switch_lobe(self, part: FitPart, index: int, on: bool) -> None:
        off = self.options.lobes_off
        self.set_options(lobes_off=off - {(part, index)} if on else off | {(part, index)})

    def target_of(self, subject: PlottedMaterial) -> Reflectance:
        """Return what is shown of a subject's reflectance: all of it, or its base, where the gloss is left out.

        The same object until the reflectance is another. Data that nothing divides are shown whole.
        """
        whole = subject.reflectance
        if self.options.gloss:
            return whole
        kept = self._bases.get(subject.key)
        if kept is None or kept[0] is not whole:
            layers = split_layers(whole)
            kept = self._bases[subject.key] = (whole, whole if layers is None else layers.base)
        return kept[1]

    def lobes_off(self, subject: PlottedMaterial) -> frozenset[tuple[FitPart, int]]:
        """Return the lobes of a subject's fit that are not shown: those switched off, and a gloss that is left out."""
        off = self.options.lobes_off
        if subject.fit is None or self.target_of(subject) is subject.reflectance:
            return off
        return off | {("gloss", index) for index in range(len(subject.fit.weights.exponents))}

    def weights_of(self, subject: PlottedMaterial) -> LobeWeights | None:
        """Return the weights of a subject's fit, 0 for lobes that are not shown; None without a fit."""
        off = self.lobes_off(subject)
        if subject.fit is None or not off:
            return None if subject.fit is None else subject.fit.weights
        weights = subject.fit.weights
        kd, kdd, kg = weights.kd.copy(), weights.kdd.copy(), weights.kg.copy()
        for part, index in off:
            rows = {"diffuse": kd[None], "directional": kdd, "gloss": kg}[part]
            if index < len(rows):
                rows[index] = 0.0
        return replace(weights, kd=kd, kdd=kdd, kg=kg)

    def _set_seen(self, hidden: frozenset[str], solo: frozenset[str]) -> None:
        keys = frozenset(s.key for s in self.subjects)
        hidden, solo = hidden & keys, solo & keys
        if (hidden, solo) != (self._hidden, self._solo):
            self._hidden, self._solo = hidden, solo
            self.visibility_changed.emit()


def light_at(theta_deg: float, phi_deg: float) -> Floats:
    """Return the unit direction (3,) to a light at an incidence as :attr:`LobeSession.incidence` has it.

    >>> light_at(90.0, 0.0).round(9).tolist()
    [-1.0, 0.0, 0.0]
    """
    return spherical(np.radians(theta_deg), np.radians(phi_deg) + np.pi)
