"""The version of the suite: the one place that states it, from which the package's metadata are made too."""

__version__ = "0.2.0"
