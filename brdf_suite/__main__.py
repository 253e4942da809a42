"""Start of the command: what ``brdf-suite`` and ``python -m brdf_suite`` run."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from brdf_suite.interrupts import end_at_interrupt


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command with ``arguments`` (default: those of this process); return the exit status."""
    end_at_interrupt()
    from brdf_suite.cli.main import main as run

    return run(arguments)


if __name__ == "__main__":
    sys.exit(main())
