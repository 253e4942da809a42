"""The one interface between a program and its features."""

from __future__ import annotations


class Feature:
    """One feature of a program; when it is made it adds its widgets and commands to the window.

    A plain class, so that it can be combined with QObject. The defaults suit a feature without work of its own.
    """

    def start(self) -> None:
        """Begin what can wait until the window is painted."""

    @property
    def is_idle(self) -> bool:
        """Whether no work of the feature is pending and all that it shows is drawn."""
        return True

    def run_script(self, _key: str, _value: str, /) -> bool:
        """Set an option by its key and value, for runs without a user; False where the feature has no such option."""
        return False

    def close(self) -> None:
        """End threads, processes and connections; called once, as the program ends."""
