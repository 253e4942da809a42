"""Start of Color Swatch: what ``brdf-swatch`` and ``python -m brdf_color_swatch`` run."""

from __future__ import annotations

import sys

from brdf_suite.interrupts import end_at_interrupt


def main() -> int:
    """Run Color Swatch with the arguments of this process; return the exit status."""
    end_at_interrupt()
    from brdf_color_swatch.command_line import main as run

    return run()


if __name__ == "__main__":
    sys.exit(main())
