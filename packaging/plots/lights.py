"""Plot how far a number of directional lights is from the whole environment: ``plots/lights.py [--shared]``.

Irradiance and a glossy lobe (R·ω)^50 along random directions, all methods, 1 to 1,024 lights, on the generated
environments: docs/images/lights_error.png, and a table of the same figures. ``--shared`` prints the table for the
files in the shared folder instead, and draws nothing. Errors are RMS over 400 directions and three channels, in per
cent of the mean over those directions; the truth is the sum over all texels.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from statistics import median
from time import perf_counter

import numpy as np

from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.lights import METHODS, DirectionalLights, directional_lights
from brdf_suite.lighting.lights.cells import sum_cells
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.pipeline.scene import environment_names, find_environment

ROOT = Path(__file__).resolve().parents[2]
TARGET = ROOT / "docs" / "images" / "lights_error.png"
COUNTS = tuple(2**k for k in range(11))
EXPONENT = 50.0
LOBES = {"irradiance": 1.0, f"glossy lobe, exponent {EXPONENT:g}": EXPONENT}
# Colours that stay apart for the colour-blind (Okabe and Ito), and a dash each.
LOOKS = {
    "median-cut": ("#0072B2", "--", "s"),
    "structured": ("#D55E00", ":", "^"),
    "relaxed": ("#000000", "-", "o"),
}

Errors = dict[str, dict[str, list[float]]]


def directions(count: int = 400) -> np.ndarray:
    """Return random unit directions (count, 3), always the same."""
    drawn = np.random.default_rng(20).normal(size=(count, 3))
    return drawn / np.linalg.norm(drawn, axis=1, keepdims=True)


def errors_of(environment: Environment) -> Errors:
    """Return for each lobe and method the error in per cent for each of ``COUNTS``."""
    cells = sum_cells(environment.radiance)
    wanted = directions()
    # The cells are turned against the map: asking along directions turned alike asks the same.
    back = (
        DirectionalLights(wanted, np.zeros((len(wanted), 3)), np.ones(len(wanted)))
        .turned(-cells.turn)
        .directions
    )
    towards, energy = cells.centres().reshape(-1, 3), cells.energy.reshape(-1, 3)
    found: Errors = {}
    lights = {(m, n): directional_lights(environment, n, m) for m in METHODS for n in COUNTS}
    for name, exponent in LOBES.items():
        truth = np.concatenate(
            [np.maximum(part @ towards.T, 0.0) ** exponent @ energy for part in np.array_split(back, 20)]
        )
        found[name] = {}
        for method in METHODS:
            found[name][method] = []
            for count in COUNTS:
                few = lights[method, count]
                got = np.maximum(wanted @ few.directions.T, 0.0) ** exponent @ few.strengths
                found[name][method].append(100.0 * float(np.sqrt(np.mean((got - truth) ** 2)) / truth.mean()))
    return found


def print_table(name: str, found: Errors) -> None:
    """Print the errors of one environment as rows of a Markdown table."""
    for lobe, methods in found.items():
        for method, values in methods.items():
            cells = " | ".join(f"{values[COUNTS.index(n)]:.3g}" for n in (1, 4, 16, 64, 256, 1024))
            print(f"| {name} | {lobe} | {method} | {cells} |", flush=True)


def draw(every: dict[str, Errors]) -> None:
    """Draw the errors of all environments: a column each, a row for each lobe."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(
        len(LOBES), len(every), figsize=(10.5, 6.2), sharex=True, sharey="row", squeeze=False
    )
    for column, (name, found) in enumerate(every.items()):
        for row, lobe in enumerate(LOBES):
            axis = axes[row, column]
            for method, (colour, dash, mark) in LOOKS.items():
                axis.loglog(
                    COUNTS,
                    found[lobe][method],
                    color=colour,
                    ls=dash,
                    marker=mark,
                    ms=4,
                    lw=1.4,
                    label=method,
                )
            axis.grid(True, which="major", color="0.85", lw=0.6)
            axis.set_xticks(COUNTS[::2], [f"{n:,}" for n in COUNTS[::2]])
            axis.minorticks_off()
            if row == 0:
                axis.set_title(name)
            if row == len(LOBES) - 1:
                axis.set_xlabel("number of lights")
            if column == 0:
                axis.set_ylabel(f"{lobe}:\nRMS error, % of the mean")
    axes[0, 0].legend(frameon=False)
    figure.tight_layout()
    figure.savefig(TARGET, dpi=110)
    print(f"{TARGET}: {TARGET.stat().st_size / 1000:.0f} kB")


def shared_files() -> Iterator[tuple[str, Path]]:
    """Yield the names and paths of the shared environments."""
    root = Path(os.environ.get("BRDF_SUITE_SHARED", ROOT.parent / "shared"))
    yield from ((path.stem, path) for path in sorted((root / "data" / "environments").glob("*.*r")))


def main() -> int:
    """Print the table, and draw the plot unless the shared files were asked for."""
    parser = argparse.ArgumentParser(description="Errors of directional lights over their number.")
    parser.add_argument("--shared", action="store_true", help="the shared environments, as a table only")
    options = parser.parse_args()
    files = (
        list(shared_files()) if options.shared else [find_environment(name) for name in environment_names()]
    )
    if not files:
        raise SystemExit(
            "There are no shared environments; set BRDF_SUITE_SHARED to the folder that holds data/."
        )
    print(
        "| environment | of | method | 1 | 4 | 16 | 64 | 256 | 1,024 |\n|---|---|---|---|---|---|---|---|---|"
    )
    every: dict[str, Errors] = {}
    lost, times = 0.0, {}
    for name, path in files:
        environment = read_environment(path)
        every[name] = errors_of(environment)
        print_table(name, every[name])
        whole = sum_cells(environment.radiance).energy.sum(axis=(0, 1))
        for method in METHODS:
            for count in (1, 16, 1024):
                start = perf_counter()
                lights = directional_lights(environment, count, method)
                times.setdefault((method, count), []).append(perf_counter() - start)
                lost = max(lost, float(np.abs(lights.strengths.sum(axis=0) / whole - 1.0).max()))
    print(f"\nenergy not kept, at most: {lost:.1e}")
    for (method, count), taken in times.items():
        print(f"{method}, {count:,} lights: {median(taken):.2f} s, median over the maps")
    if not options.shared:
        draw(every)
    return 0


if __name__ == "__main__":
    sys.exit(main())
