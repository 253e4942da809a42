"""Start of Lobe Visualizer: what ``brdf-lobes`` and ``python -m brdf_lobe_visualizer`` run."""

from __future__ import annotations

import sys

from brdf_suite.interrupts import end_at_interrupt


def main() -> int:
    """Run Lobe Visualizer with the arguments of this process; return the exit status."""
    end_at_interrupt()
    from brdf_lobe_visualizer.command_line import main as run

    return run()


if __name__ == "__main__":
    sys.exit(main())
