"""Neutral themes: people judge colour beside these surfaces, so every grey has R = G = B.

A theme is one lightness L* for the surround and the lightnesses of what lies on it. The single accent marks
focus and selection and nothing else. Widgets take their colours from the palette; none carries a style sheet.
"""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QActionGroup, QColor, QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication, QMenu, QWidget

from brdf_qt.program.settings import SHARED, settings
from brdf_qt.program.translation import mark, tr

THEMES = ("dark", "booth", "light", "system")
TITLES = {
    "dark": mark("Dark (L* 20)"),
    "booth": mark("Booth (L* 50)"),
    "light": mark("Light (L* 85)"),
    "system": mark("Follow the system"),
}
DEFAULT = "dark"
_KEY = "theme"


def grey(lightness: float) -> QColor:
    """Return the sRGB grey of CIE lightness L* (0…100), R = G = B.

    CIE 15: Y = ((L* + 16)/116)³ above L* = 8; sRGB transfer curve of IEC 61966-2-1.
    """
    f = (lightness + 16.0) / 116.0
    y = f**3 if lightness > 8.0 else lightness / 903.2963
    code = 12.92 * y if y <= 0.0031308 else 1.055 * y ** (1 / 2.4) - 0.055
    level = round(255 * min(1.0, max(0.0, code)))
    return QColor(level, level, level)


@dataclass(frozen=True)
class _Tones:
    """Lightness L* of each kind of surface, and the one accent.

    ``box`` is that of a check box or radio button, which on a dark window has no outline to be seen by.
    """

    window: float
    base: float
    box: float
    button: float
    text: float
    faint: float
    bright: float
    shade: float
    accent: str
    accent_text: float


_TONES = {
    "dark": _Tones(20, 14, 38, 27, 88, 52, 38, 8, "#4a7fb8", 100),
    "booth": _Tones(50, 58, 68, 56, 0, 32, 68, 36, "#153f66", 100),
    "light": _Tones(85, 94, 98, 90, 10, 52, 98, 66, "#2a66a0", 100),
}


_STATES = {
    "good": ("#6cc070", "#00330f", "#1e6b2a"),
    "warning": ("#e0a53a", "#3d2800", "#855600"),
    "bad": ("#ff7468", "#5c0000", "#b3261e"),
}
"""Colours of states on dark, middle and light grounds, three to one or more against each."""


def state_colour(kind: str, ground: QColor) -> str:
    """Return the colour of a state, ``good``, ``warning`` or ``bad``, on a window of grey ``ground``."""
    dark, middle, light = _STATES[kind]
    level = ground.lightnessF()
    return dark if level < 0.33 else middle if level < 0.66 else light


def _tones_of(name: str) -> _Tones:
    if name == "system":
        light = QGuiApplication.styleHints().colorScheme() == Qt.ColorScheme.Light
        name = "light" if light else "dark"
    return _TONES[name]


def palette(name: str) -> QPalette:
    """Return the palette of theme ``dark``, ``booth`` or ``light``; ``system`` becomes dark or light."""
    tones = _tones_of(name)
    p = QPalette()
    role = QPalette.ColorRole
    for which, lightness in (
        (role.Window, tones.window),
        (role.WindowText, tones.text),
        (role.Base, tones.base),
        (role.AlternateBase, (tones.base + tones.window) / 2),
        (role.Text, tones.text),
        (role.Button, tones.button),
        (role.ButtonText, tones.text),
        (role.BrightText, tones.text),
        (role.ToolTipBase, tones.base),
        (role.ToolTipText, tones.text),
        (role.PlaceholderText, tones.faint),
        (role.Light, tones.bright),
        (role.Midlight, (tones.bright + tones.button) / 2),
        (role.Mid, (tones.shade + tones.button) / 2),
        (role.Dark, tones.shade),
        (role.Shadow, tones.shade * 0.6),
    ):
        p.setColor(which, grey(lightness))
    accent = QColor(tones.accent)
    for which in (role.Highlight, role.Accent, role.Link, role.LinkVisited):
        p.setColor(which, accent)
    p.setColor(role.HighlightedText, grey(tones.accent_text))
    off = QPalette.ColorGroup.Disabled
    for which in (role.WindowText, role.Text, role.ButtonText):
        p.setColor(off, which, grey(tones.faint))
    p.setColor(off, role.Base, grey((tones.base + tones.window) / 2.0))
    p.setColor(off, role.Highlight, grey(tones.faint))
    p.setColor(off, role.Accent, grey(tones.faint))
    return p


def _show(app: QApplication, name: str) -> None:
    shown = palette(name)
    app.setPalette(shown)
    tones = _tones_of(name)
    shown.setColor(QPalette.ColorRole.Base, grey(tones.box))
    off = (tones.box + tones.window) / 2.0
    shown.setColor(QPalette.ColorGroup.Disabled, QPalette.ColorRole.Base, grey(off))
    for kind in ("QCheckBox", "QRadioButton"):
        app.setPalette(shown, kind)  # type: ignore[arg-type]  # PySide6 takes text, its stub has bytes


def current() -> str:
    """Return the name of the theme that was chosen in any of the programs."""
    name = str(settings(SHARED).value(_KEY, DEFAULT))
    return name if name in THEMES else DEFAULT


def shown() -> str:
    """Return the name of the theme of this run, which may be another than the chosen one."""
    app = QApplication.instance()
    return str((app and app.property("theme")) or current())


def apply(app: QApplication, name: str, *, remember: bool = True) -> None:
    """Give the whole program theme ``name``; remembered for all programs."""
    _show(app, name)
    app.setProperty("theme", name)
    if remember:
        settings(SHARED).setValue(_KEY, name)


def follow_changes(app: QApplication) -> None:
    """Change with the system's light or dark setting while the theme is ``system``, and with the other programs.

    What was chosen in another program is taken up when this one is used next.
    """

    def scheme_changed() -> None:
        if app.property("theme") == "system":
            _show(app, "system")

    known = current()

    def used(state: Qt.ApplicationState) -> None:
        nonlocal known
        if state == Qt.ApplicationState.ApplicationActive:
            settings(SHARED).sync()
            if current() != known:
                known = current()
                apply(app, known, remember=False)

    QGuiApplication.styleHints().colorSchemeChanged.connect(scheme_changed)
    app.applicationStateChanged.connect(used)


def theme_menu(parent: QWidget | None = None) -> QMenu:
    """Return the menu View ▸ Theme: one checkable entry per theme."""
    menu = QMenu(tr("&Theme"), parent)
    group = QActionGroup(menu)
    app = QApplication.instance()
    for name in THEMES:
        action = QAction(tr(TITLES[name]), menu, checkable=True)
        action.setObjectName(f"theme_{name}")
        action.setData(name)
        group.addAction(action)
        menu.addAction(action)

    def tick() -> None:
        for action in group.actions():
            action.setChecked(action.data() == shown())

    def choose(action: QAction) -> None:
        if isinstance(app, QApplication):
            apply(app, str(action.data()))

    group.triggered.connect(choose)
    menu.aboutToShow.connect(tick)
    tick()
    return menu
