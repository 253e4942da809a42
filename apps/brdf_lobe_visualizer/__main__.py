"""Lobe Visualizer: any reflectance in three dimensions. ``brdf-lobes --help`` tells its options."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from brdf_qt.application import create_application, run
from brdf_qt.arguments import window_size
from brdf_qt.theme import THEMES

from brdf_lobe_visualizer.assembly import LobeVisualizer


def main(argv: Sequence[str] | None = None) -> int:
    """Run Lobe Visualizer; return the exit status."""
    options = _parser().parse_args(argv)
    app = create_application("Lobe Visualizer", theme_name=options.theme)
    program = LobeVisualizer()
    if options.size is not None:
        program.window.resize(*options.size)
        program.window.fit_inspector()
    program.start()
    return run(app, program.window)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="brdf-lobes", description="Look at reflectances in three dimensions."
    )
    parser.add_argument("--theme", choices=THEMES, help="surround of this run (default: the one chosen last)")
    parser.add_argument("--size", type=window_size, metavar="WxH", help="size of the window in pixels")
    return parser


if __name__ == "__main__":
    sys.exit(main())
