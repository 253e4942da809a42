"""The session that every part of the window shares: subjects, light and options, with signals for changes.

A part is made with ``(session, window)``, adds its widgets to the window and listens to the session.
No part knows another.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from brdf_qt.window.message_bar import Message
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject, Signal

from brdf_lobe_visualizer.options import INCIDENCE_DEG, MOST_THETA_DEG, Options, Part
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial
from brdf_suite.arrays import Floats
from brdf_suite.geometry.directions import spherical

if TYPE_CHECKING:
    from brdf_suite.fitting.lobes.weights import LobeWeights


class Messages(Protocol):
    """Where messages are shown: the window."""

    def show_message(self, message: Message) -> None:
        """Show a message in the window."""

    def dismiss_message(self, key: str) -> None:
        """Take a message away."""


class LobeSession(QObject):
    """All subjects, in the order of the legend, and the options that the views share.

    Signals
    -------
    subjects_changed()
        Subjects came, went, changed their place, or one is another now (its reflectance, fit, title or line).
    front_changed()
        Another subject is the one that is selected. Changes of the subject itself emit ``subjects_changed``.
    visibility_changed()
        Others are visible, by show or solo, or the one that differences are taken against is another.
    incidence_changed(theta_deg, phi_deg)
        The light stands elsewhere.
    options_changed()
        Channel, radius, cosine, what is shown, or the lobes that are switched on.
    view_reset()
        The view of a first start is restored; a feature resets what only it knows of it.
    """

    subjects_changed = Signal()
    front_changed = Signal()
    visibility_changed = Signal()
    incidence_changed = Signal(float, float)
    options_changed = Signal()
    view_reset = Signal()

    def __init__(self, messages: Messages, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._messages = messages
        self.tasks = TaskRunner(self)
        self._subjects: tuple[PlottedMaterial, ...] = ()
        self._front = ""
        self._reference_key = ""
        self._hidden: frozenset[str] = frozenset()
        self._solo: frozenset[str] = frozenset()
        self._incidence = INCIDENCE_DEG
        self._options = Options()

    # The subjects.

    @property
    def subjects(self) -> tuple[PlottedMaterial, ...]:
        """All of them, in the order of the legend; there may be none."""
        return self._subjects

    @property
    def visible(self) -> tuple[PlottedMaterial, ...]:
        """Those that are shown: where any is solo those, else all that are not hidden."""
        if self._solo:
            return tuple(s for s in self._subjects if s.key in self._solo)
        return tuple(s for s in self._subjects if s.key not in self._hidden)

    @property
    def front(self) -> PlottedMaterial | None:
        """The one that is selected; None only where there is none."""
        return self._of(self._front)

    @property
    def reference(self) -> PlottedMaterial | None:
        """The one that differences are taken against: the reference; None where none was chosen."""
        return self._of(self._reference_key)

    def subject(self, key: str) -> PlottedMaterial | None:
        """Return the subject of that key, None where there is none."""
        return self._of(key)

    def set_subjects(self, subjects: Sequence[PlottedMaterial]) -> None:
        """Put these in the place of all; what was said of keys that stay (front, hidden, solo) stays."""
        before_front, before = self._front, (self._hidden, self._solo, self._reference_key)
        self._subjects = tuple(subjects)
        keys = frozenset(s.key for s in self._subjects)
        if self._front not in keys:
            self._front = self._subjects[0].key if self._subjects else ""
        if self._reference_key not in keys:
            self._reference_key = ""
        self._hidden &= keys
        self._solo &= keys
        self.subjects_changed.emit()
        if self._front != before_front:
            self.front_changed.emit()
        if (self._hidden, self._solo, self._reference_key) != before:
            self.visibility_changed.emit()

    def add(self, subject: PlottedMaterial) -> None:
        """Put a subject at the end, or in the place of the one with its key."""
        if self._of(subject.key) is None:
            self.set_subjects((*self._subjects, subject))
        else:
            self.set_subjects([subject if s.key == subject.key else s for s in self._subjects])

    def change(self, key: str, **fields: Any) -> None:
        """Give the subject of that key other fields; nothing where it has gone."""
        subject = self._of(key)
        if subject is not None:
            self.add(replace(subject, **fields))

    def remove(self, key: str) -> None:
        """Take a subject away; its neighbour becomes the front where it was that."""
        keys = [s.key for s in self._subjects]
        if key not in keys:
            return
        place = keys.index(key)
        rest = [s for s in self._subjects if s.key != key]
        if key == self._front and rest:
            self._front = rest[min(place, len(rest) - 1)].key
            self.set_subjects(rest)
            self.front_changed.emit()
        else:
            self.set_subjects(rest)

    def move(self, key: str, place: int) -> None:
        """Put a subject at ``place``, 0 the first, of the legend's order."""
        subject = self._of(key)
        if subject is not None:
            rest = [s for s in self._subjects if s.key != key]
            rest.insert(min(max(place, 0), len(rest)), subject)
            if tuple(rest) != self._subjects:
                self.set_subjects(rest)

    def set_front(self, key: str) -> None:
        """Select the subject of that key."""
        if key != self._front and self._of(key) is not None:
            self._front = key
            self.front_changed.emit()

    def set_reference(self, key: str | None) -> None:
        """Take differences against the subject of that key, or against none."""
        wanted = key if key and self._of(key) is not None else ""
        if wanted != self._reference_key:
            self._reference_key = wanted
            self.visibility_changed.emit()

    # Which are seen.

    def is_hidden(self, key: str) -> bool:
        """Whether the subject is switched off in the legend."""
        return key in self._hidden

    def is_solo(self, key: str) -> bool:
        """Whether the subject is among those that are shown alone."""
        return key in self._solo

    def set_hidden(self, key: str, hidden: bool) -> None:
        """Show or hide a subject."""
        self._set_seen(self._hidden | {key} if hidden else self._hidden - {key}, self._solo)

    def set_solo(self, key: str, solo: bool) -> None:
        """Show a subject alone, with the others that are so, or no more."""
        self._set_seen(self._hidden, self._solo | {key} if solo else self._solo - {key})

    def show_all(self) -> None:
        """Hide none and let none be alone."""
        self._set_seen(frozenset(), frozenset())

    # The light.

    @property
    def incidence(self) -> tuple[float, float]:
        """Polar angle (0 to 89.9) and azimuth (above -180, to 180) of the plane of incidence, degrees.

        At azimuth 0 the light stands on the -x side and its mirror direction leans to +x, as in
        :func:`brdf_suite.geometry.directions.illumination`.
        """
        return self._incidence

    @property
    def light(self) -> Floats:
        """The unit direction (3,) to the light."""
        return light_at(*self._incidence)

    def set_incidence(self, theta_deg: float, phi_deg: float) -> None:
        """Put the light there; angles are brought into their range."""
        theta = min(max(float(theta_deg), 0.0), MOST_THETA_DEG)
        # The sum takes the sign of a zero away.
        phi = 0.0 - ((180.0 - float(phi_deg)) % 360.0 - 180.0)
        if (theta, phi) != self._incidence:
            self._incidence = (theta, phi)
            self.incidence_changed.emit(theta, phi)

    def reset_incidence(self) -> None:
        """Put the light where a first start has it."""
        self.set_incidence(*INCIDENCE_DEG)

    # The options.

    @property
    def options(self) -> Options:
        """How the views show what they show."""
        return self._options

    def set_options(self, **fields: Any) -> None:
        """Set options by name: ``channel``, ``radius``, ``cosine``, ``shown``, ``lobes_off``."""
        options = replace(self._options, **fields)
        if options != self._options:
            self._options = options
            self.options_changed.emit()

    def reset_options(self, *names: str) -> None:
        """Set options back, all where none is named."""
        plain = Options()
        self.set_options(**{name: getattr(plain, name) for name in names or vars(plain)})

    def reset_view(self) -> None:
        """Restore options and incidence of a first start."""
        self.reset_options()
        self.reset_incidence()
        self.view_reset.emit()

    def switch_lobe(self, part: Part, index: int, on: bool) -> None:
        """Switch a lobe of the fits on or off."""
        off = self._options.lobes_off
        self.set_options(lobes_off=off - {(part, index)} if on else off | {(part, index)})

    def weights_of(self, subject: PlottedMaterial) -> LobeWeights | None:
        """Return the weights of a subject's fit with the lobes that are switched off at 0; None without a fit."""
        if subject.fit is None or not self._options.lobes_off:
            return None if subject.fit is None else subject.fit.weights
        weights = subject.fit.weights
        kd, kdd, kg = weights.kd.copy(), weights.kdd.copy(), weights.kg.copy()
        for part, index in self._options.lobes_off:
            rows = {"diffuse": kd[None], "directional": kdd, "gloss": kg}[part]
            if index < len(rows):
                rows[index] = 0.0
        return replace(weights, kd=kd, kdd=kdd, kg=kg)

    # Messages.

    def show_message(self, message: Message) -> None:
        """Show a message in the window."""
        self._messages.show_message(message)

    def dismiss_message(self, key: str) -> None:
        """Take a message away."""
        self._messages.dismiss_message(key)

    def _of(self, key: str) -> PlottedMaterial | None:
        return next((s for s in self._subjects if s.key == key), None)

    def _set_seen(self, hidden: frozenset[str], solo: frozenset[str]) -> None:
        keys = frozenset(s.key for s in self._subjects)
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
