"""Start of the command: what ``brdf-suite`` and ``python -m brdf_suite`` run."""

from __future__ import annotations

import sys

from brdf_suite.interrupts import end_at_interrupt


def main() -> int:
    """Run the command with the arguments of this process; return the exit status."""
    end_at_interrupt()
    from brdf_suite.cli.main import main as run

    return run()


if __name__ == "__main__":
    sys.exit(main())
