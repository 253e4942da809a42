"""Start of the Viewer: what ``brdf-viewer`` and ``python -m brdf_viewer`` run."""

from __future__ import annotations

import sys

from brdf_suite.interrupts import end_at_interrupt


def main() -> int:
    """Run the Viewer with the arguments of this process; return the exit status."""
    end_at_interrupt()
    from brdf_viewer.command_line import main as run

    return run()


if __name__ == "__main__":
    sys.exit(main())
