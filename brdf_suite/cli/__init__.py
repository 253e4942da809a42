"""The ``brdf-suite`` command: the functions of all programs without a screen."""
