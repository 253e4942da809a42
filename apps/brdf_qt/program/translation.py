"""Words of the windows in the user's language: ``tr`` where a text is shown, ``mark`` where it is kept.

Sources are the English texts themselves; ``packaging/translate.py`` collects them and makes the ``.qm`` files.
A text is a literal with named places (``tr("Saved in {folder}").format(folder=name)``), never an f-string: the
tool that collects them reads the source. Finished texts of the core (errors, notices, steps of work) go through
:func:`brdf_qt.program.core_texts.tr_core`.
"""

from __future__ import annotations

import re
import string
from datetime import datetime
from functools import cache
from numbers import Real
from typing import Any

from PySide6.QtCore import QCoreApplication, QDate, QLibraryInfo, QLocale, QTranslator
from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QMenu

from brdf_qt.program.settings import SHARED, settings
from brdf_suite.resources import resource, resource_names

SYSTEM = "system"
SOURCE = "en"
_ENDING = ".qm"
_KEY = "language"


_NUMBER = re.compile(r"[-+−]?\d+\.\d+(e[-+−]?\d+)?")
_THOUSANDS = re.compile(r"(?<=\d),(?=\d{3}(?:\D|$))")


class _Numbers(string.Formatter):
    """Fills places in a text, and writes numbers there as the language has them, also those that are texts already."""

    def format_field(self, value: Any, format_spec: str) -> Any:
        text = super().format_field(value, format_spec)
        number = (
            _NUMBER.fullmatch(text) if isinstance(value, str) else format_spec and isinstance(value, Real)
        )
        return decimal(text) if number else text


_NUMBERS = _Numbers()


class Text(str):
    """A text of the program's language: numbers that are put into its places have the decimal sign of that."""

    __slots__ = ()

    def format(self, *args: object, **named: object) -> str:
        if point() == ".":
            return super().format(*args, **named)
        return _NUMBERS.vformat(self, args, named)


@cache
def point() -> str:
    """Return the decimal sign of the program's language."""
    app = QCoreApplication.instance()
    code = app.property(_KEY) if app is not None else None
    return "." if code in (None, SOURCE) else QLocale(str(code)).decimalPoint()


def group_sign() -> str:
    """Return what divides thousands in the program's language."""
    code = language_in_use(QCoreApplication.instance())
    return "," if code == SOURCE else QLocale(code).groupSeparator()


def decimal(text: str) -> str:
    """Return a number that Python has written with the decimal sign of the program's language.

    Where that is no point, thousands are divided as the language does: a comma would be read as the sign.
    For what is shown alone: files, clipboards for other programs and options of commands keep the point.
    """
    sign = point()
    if sign == ".":
        return text
    return _THOUSANDS.sub("\0", text).replace(".", sign).replace("\0", group_sign())


@cache
def tr(text: str, comment: str | None = None) -> str:
    """Return ``text`` in the language of the program; as it is where no translation is installed.

    ``comment`` distinguishes two meanings of one English word. A drag asks for the same forty texts a hundred times a
    second, so they are kept.
    """
    return Text(QCoreApplication.translate("", text, comment))


def mark(text: str, _comment: str | None = None) -> str:
    """Return ``text`` itself: a constant that is handed to :func:`tr` later, when a translator is there."""
    return text


def languages() -> list[str]:
    """Return the languages that there are, by their ISO 639 codes, English first."""
    return [SOURCE, *resource_names("translations", _ENDING)]


def chosen() -> str:
    """Return the language that the user chose in any of the programs: a code, or ``system``."""
    code = str(settings(SHARED).value(_KEY, SYSTEM))
    return code if code in languages() else SYSTEM


def remember(code: str) -> None:
    """Choose the language that every program has from its next start on."""
    settings(SHARED).setValue(_KEY, code)


def language_in_use(app: QCoreApplication | None) -> str:
    """Return the code of the language that ``app`` shows."""
    code = app.property(_KEY) if app is not None else None
    return SOURCE if code is None else str(code)


def install(app: QCoreApplication, code: str | None = None) -> str:
    """Install the translators of ``code`` (default: what was chosen) for ``app``; return the code taken.

    Before the first widget: texts that are shown already stay as they are.
    """
    tr.cache_clear()
    taken = _installed(app, code)
    app.setProperty(_KEY, taken)
    point.cache_clear()
    return taken


def moment(when: datetime) -> str:
    """Return a date and a time of day as the language of the program writes them."""
    app = QCoreApplication.instance()
    code = app.property(_KEY) if app is not None else None
    # English is that of the program's own words.
    locale = QLocale("en_GB" if code in (None, SOURCE) else str(code))
    form = re.sub(r"dddd,?\s*", "", locale.dateFormat(QLocale.FormatType.LongFormat))
    return f"{locale.toString(QDate(when.year, when.month, when.day), form)}, {when:%H:%M}"


def _installed(app: QCoreApplication, code: str | None) -> str:
    wanted = code or chosen()
    if wanted == SYSTEM:
        wanted = QLocale.system().name().partition("_")[0]
    if wanted not in languages() or wanted == SOURCE:
        return SOURCE
    ours = QTranslator(app)
    if not ours.load(str(resource("translations", wanted + _ENDING))):
        return SOURCE
    app.installTranslator(ours)
    # The buttons of Qt's own dialogs; where Qt ships none for a language, they stay English.
    qts = QTranslator(app)
    if qts.load(f"qtbase_{wanted}", QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)):
        app.installTranslator(qts)
    return wanted


def language_names() -> dict[str, str]:
    """Return what can be chosen: each language in its own words, by its code, and the system's first."""
    names = {SYSTEM: tr("System Default")}
    names |= {code: QLocale(code).nativeLanguageName().capitalize() for code in languages()}
    return names | {SOURCE: "English"}


def language_menu(parent: QMenu) -> QMenu:
    """Return the menu that chooses the language of all programs from their next start on."""
    menu = QMenu(tr("&Language"), parent)
    menu.setToolTipsVisible(True)
    group = QActionGroup(menu)
    for code, name in language_names().items():
        action = QAction(name, menu, checkable=True, checked=code == chosen())
        action.setObjectName(f"language_{code}")
        action.setToolTip(tr("For all programs, from their next start on"))
        action.triggered.connect(lambda _checked=False, code=code: remember(code))
        group.addAction(action)
        menu.addAction(action)
    return menu
