"""Fields for options: a drop-down list with a default, and a form whose fields set options by name and show them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from brdf_qt.fields.form import Form
from brdf_qt.fields.number import NumberField
from brdf_qt.fields.quiet import QuietComboBox
from brdf_qt.program.translation import tr
from PySide6.QtCore import QEvent, Qt, Signal, SignalInstance
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QCheckBox, QComboBox, QWidget

from brdf_lobe_visualizer.options import Options, OptionState
from brdf_lobe_visualizer.session import LobeSession

_RESETS = (Qt.Key.Key_Backspace, Qt.Key.Key_Delete)


class ChoiceField(QuietComboBox):
    """Choices by key with titles (marked for translation); ``default`` is what Backspace or Delete goes back to.

    ``chosen(key)`` is never emitted by :meth:`set_choice`.
    """

    chosen = Signal(object)

    def __init__(self, titles: Mapping[Any, str], default: Any, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.default = default
        for key, title in titles.items():
            self.addItem(tr(title), key)
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(8)
        self.activated.connect(lambda index: self.chosen.emit(self.itemData(index)))

    @property
    def choice(self) -> Any:
        return self.currentData()

    def set_choice(self, key: Any) -> None:
        """Show a choice without a signal."""
        self.setCurrentIndex(self.findData(key))

    def reset(self) -> None:
        """Go back to the default, as a choice of the user's."""
        if self.choice != self.default:
            self.set_choice(self.default)
            self.chosen.emit(self.default)

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress and event.key() in _RESETS:
            self.reset()
            return True
        return super().event(event)


class OptionForm(Form):
    """Fields for the options of a view, and for the session's where the view has none of that name.

    Each kind of field takes ``name``, the option, and ``act``, which is called in the place of setting it.
    """

    def __init__(self, state: OptionState[Any], session: LobeSession | None = None) -> None:
        super().__init__()
        self._state, self._session = state, session
        self._shows: list[Callable[[], None]] = []

    def choice(
        self,
        name: str,
        titles: Mapping[Any, str],
        label: str,
        tip: str = "",
        act: Callable[[Any], None] | None = None,
    ) -> ChoiceField:
        """Add a row with a drop-down list of ``titles``."""
        field = ChoiceField(titles, self._plain(name))
        self._bind(name, field.chosen, field.set_choice, act)
        self.add_row(label, field, tip)
        return field

    def number(
        self,
        name: str,
        label: str,
        spoken: str,
        unit: str,
        ends_step: tuple[float, float, float],
        decimals: int,
        tip: str = "",
        act: Callable[[Any], None] | None = None,
    ) -> NumberField:
        """Add a row with a number; ``ends_step`` are its least and greatest value and its step."""
        field = NumberField(spoken, unit, *ends_step, decimals, self._plain(name))
        self._bind(name, field.edited, field.set_value, act)
        self.add_row(label, field, tip)
        return field

    def tick(self, name: str, text: str) -> QCheckBox:
        """Return a box to be ticked, which is not in the form yet."""
        box = QCheckBox(text)
        self._bind(name, box.clicked, box.setChecked, None)
        return box

    def show_now(self) -> None:
        """Show the options as they are, without a signal."""
        for show in self._shows:
            show()

    def _bind(
        self,
        name: str,
        edited: SignalInstance,
        show: Callable[[Any], None],
        act: Callable[[Any], None] | None,
    ) -> None:
        edited.connect(act or (lambda value: self._set(name, value)))
        self._shows.append(lambda: show(self._value(name)))

    def _plain(self, name: str) -> Any:
        return (vars(Options()) | vars(self._state.plain))[name]

    def _value(self, name: str) -> Any:
        shared = {} if self._session is None else vars(self._session.options)
        return (shared | vars(self._state.options))[name]

    def _set(self, name: str, value: Any) -> None:
        if self._session is None or name in vars(self._state.plain):
            self._state.set(**{name: value})
        else:
            self._session.set_options(**{name: value})
