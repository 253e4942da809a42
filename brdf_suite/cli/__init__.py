"""The ``brdf-suite`` command: everything that the programs do, without a screen."""
