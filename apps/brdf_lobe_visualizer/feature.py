"""What the program asks of each of its features: views, plots and panels."""

from __future__ import annotations

from PySide6.QtCore import QObject


class LobeFeature(QObject):
    """A feature that adds itself to the window, as its child. The defaults suit one without work of its own."""

    @property
    def is_complete(self) -> bool:
        """Whether all that it shows is there."""
        return True

    def close(self) -> None:
        """End its work; called once, as the program ends."""

    def reset_view(self) -> None:
        """Restore the view of a first start."""

    def set_from_script(self, _key: str, _value: str, /) -> bool:
        """Take an option of the command line by key and value; False if the feature does not have it."""
        return False
