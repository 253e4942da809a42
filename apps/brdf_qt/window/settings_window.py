"""Edit ▸ Settings: what all four programs have in common, in one window that is the same in each."""

from __future__ import annotations

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QApplication, QCheckBox, QDialog, QDialogButtonBox, QMainWindow, QPushButton

from brdf_qt.fields.form import Form, fill_column
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.fields.quiet import QuietComboBox
from brdf_qt.program import theme, translation
from brdf_qt.program.translation import tr
from brdf_qt.start import page as start_page
from brdf_qt.window.dialogs import without_icons


class SettingsWindow(QDialog):
    """Theme, language, lobe fit and start page; a choice holds at once, and is kept for all programs."""

    def __init__(self, window: QMainWindow) -> None:
        super().__init__(window)
        self.setObjectName("settings_window")
        self.setWindowTitle(tr("Settings"))
        self.theme, self.language, self.fit = QuietComboBox(), QuietComboBox(), QPushButton(tr("Lobe Fit…"))
        for name in theme.THEMES:
            self.theme.addItem(tr(theme.TITLES[name]), name)
        for code, name in translation.language_names().items():
            self.language.addItem(name, code)
        self.theme.activated.connect(self._choose_theme)
        self.language.activated.connect(lambda _row: translation.remember(self.language.currentData()))
        form = Form()
        form.add_row(tr("Theme"), self.theme, tr("Grey of all windows; colours are judged beside it"))
        form.add_row(tr("Language"), self.language, tr("For all programs, from their next start on"))
        tip = tr("Choose the exponents and the number of lobes, and how they are fitted")
        form.add_row(tr("Reflectance"), self.fit, tip)
        self.start_page = QCheckBox(tr("Show at start"))
        self.start_page.setObjectName("settings_start_page")
        self.start_page.clicked.connect(start_page.set_wanted)
        form.add_row(tr("Start page"), self.start_page, tr("Help ▸ Start Page shows it at any time"))
        note = PlainLabel(tr("These settings are the same in all programs of the suite."), wordWrap=True)
        form.add_wide(note)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.close)
        fill_column(self, form, None, buttons, margins=(16, 16, 16, 16))
        without_icons(self)
        fit = window.findChild(QAction, "action_lobe_fit")
        if isinstance(fit, QAction):
            self.fit.clicked.connect(fit.trigger)
        self.fit.setEnabled(isinstance(fit, QAction))
        self.show_choices()

    def show_choices(self) -> None:
        """Show what is chosen now: it may have been changed in a menu, or in another program."""
        self.theme.setCurrentIndex(self.theme.findData(theme.shown()))
        self.language.setCurrentIndex(self.language.findData(translation.chosen()))
        self.start_page.setChecked(start_page.is_wanted())

    def _choose_theme(self) -> None:
        app = QApplication.instance()
        if isinstance(app, QApplication):
            theme.apply(app, self.theme.currentData())
