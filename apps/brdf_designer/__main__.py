"""Start of Designer: what ``brdf-designer`` and ``python -m brdf_designer`` run."""

from __future__ import annotations

import sys

from brdf_suite.interrupts import end_at_interrupt


def main() -> int:
    """Run Designer with the arguments of this process; return the exit status."""
    end_at_interrupt()
    from brdf_designer.command_line import main as run

    return run()


if __name__ == "__main__":
    sys.exit(main())
