"""Draw the figures of docs/method/fit.md into docs/images: error over the numbers of lobes and of samples.

Run in a checkout, with the development dependencies; a minute on two cores::

    python packaging/plots/fit.py [FOLDER] [--paints N]

The figures are computed by the scripts that print the page's tables.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.axes import Axes

CHECKOUT = Path(__file__).resolve().parents[2]
# The experiments are scripts beside each other, not a package.
sys.path.insert(0, str(CHECKOUT / "tests" / "benchmarks" / "comparisons"))

import compare_samples  # noqa: E402  (found by the line above)
import compare_solvers  # noqa: E402
import matplotlib as mpl  # noqa: E402
from lobe_experiment import Database, paints  # noqa: E402

mpl.use("Agg")
from matplotlib import pyplot  # noqa: E402  (after its backend is chosen)

#: Colours that stay apart for colour-blind readers (Okabe and Ito), and a mark each.
STYLES = {"L1 program": ("#0072B2", "o"), "NNLS": ("#009E73", "s"), "clamped": ("#D55E00", "^")}
RESOLUTION = 110


def finish(axes: Axes, title: str, across: str, up: str) -> None:
    """Label and thin out."""
    axes.set_title(title, fontsize=10)
    axes.set_xlabel(across)
    axes.set_ylabel(up)
    axes.grid(visible=True, which="major", alpha=0.3)
    axes.spines[["top", "right"]].set_visible(False)


def plot_solvers(database: Database, path: Path) -> None:
    """Draw error over the number of lobes, for three solvers."""
    found = compare_solvers.curves(database)
    figure, panels = pyplot.subplots(2, 3, figsize=(12.5, 7.6), layout="constrained")
    upper = [title for title in found if title.startswith("bases")]
    lower = [title for title in found if title.startswith("coats")]
    panels[1, -1].axis("off")
    for axes, name in zip([*panels[0], *panels[1]], [*upper, *lower], strict=False):
        by_solver = found[name]
        for solver, values in by_solver.items():
            colour, mark = STYLES[solver]
            mean, largest = ([value[k] for value in values] for k in (0, 1))
            axes.semilogy(compare_solvers.COUNTS, mean, color=colour, marker=mark, label=f"{solver}, mean")
            axes.semilogy(
                compare_solvers.COUNTS,
                largest,
                color=colour,
                marker=mark,
                linestyle=":",
                markerfacecolor="white",
                label=f"{solver}, worst",
            )
        up = "share of energy misplaced" if name in lower else "ΔE00 at angles not used (RMS per paint)"
        finish(axes, name, "number of lobes", up)
        axes.set_xticks(compare_solvers.COUNTS)
    panels[1, -1].legend(*panels[0, 0].get_legend_handles_labels(), loc="center", fontsize=10, frameon=False)
    figure.savefig(path, dpi=RESOLUTION)
    pyplot.close(figure)


def plot_samples(count: int | None, path: Path) -> None:
    """Draw error over the number of samples, base and coat."""
    layers = compare_samples.both_rules(count)
    figure, (base, coat) = pyplot.subplots(1, 2, figsize=(10.0, 4.0), layout="constrained")
    most = 6 if count else compare_samples.MOST
    greedy = compare_samples.greedy(layers, most)
    halved = [compare_samples.errors(layers, compare_samples.even(n)) for n in range(4, most + 1)]
    for fits, colour, mark, name in (
        ([fit for _, fit in greedy], "#0072B2", "o", "next best angle"),
        (halved, "#D55E00", "^", "widest gap halved"),
    ):
        numbers = range(4, most + 1)
        base.semilogy(numbers, [f.rms.mean() for f in fits], color=colour, marker=mark, label=f"{name}, mean")
        base.semilogy(
            numbers,
            [f.rms.max() for f in fits],
            color=colour,
            marker=mark,
            linestyle=":",
            markerfacecolor="white",
            label=f"{name}, worst",
        )
    own = compare_samples.own_errors(layers)
    number = len(compare_samples.BASE_GAMMAS_DEG)
    base.semilogy(
        [number] * 2, [own.rms.mean(), own.rms.max()], "k*", markersize=11, label="the fitter's own"
    )
    finish(
        base,
        "Bases",
        "number of samples, 15, 45 and 110° among them",
        "ΔE00 at angles not used (RMS per paint)",
    )
    base.legend(fontsize=8)
    steps = compare_samples.STEPS[::3] if count else compare_samples.STEPS
    figures = [compare_samples.coat_errors(compare_samples.CoatSamples(log_step=s), count) for s in steps]
    rings = [f.rings for f in figures]
    coat.semilogy(
        rings, [f.misplaced.mean() for f in figures], color="#0072B2", marker="o", label="misplaced, mean"
    )
    coat.semilogy(
        rings,
        [f.misplaced.max() for f in figures],
        ":",
        color="#0072B2",
        marker="o",
        label="misplaced, worst",
    )
    coat.semilogy(rings, [f.energy for f in figures], color="#D55E00", marker="^", label="energy, worst")
    used = compare_samples.CoatSamples().gamma_rad.size
    coat.axvline(used, color="black", linewidth=0.8)
    coat.annotate(f" {used}: the fitter's own", (used, 0.72), xycoords=("data", "axes fraction"), fontsize=8)
    finish(coat, "Coats", "number of rings", "share of the coat's energy")
    coat.legend(fontsize=8, loc="center right")
    figure.savefig(path, dpi=RESOLUTION)
    pyplot.close(figure)


def main(argv: Sequence[str] | None = None) -> None:
    """Write the pictures."""
    parser = argparse.ArgumentParser(description="Draw the figures of docs/method/fit.md.")
    parser.add_argument("folder", nargs="?", type=Path, default=CHECKOUT / "docs" / "images")
    parser.add_argument("--paints", type=int, default=None, help="use so many paints of the database only")
    given = parser.parse_args(argv)
    plot_solvers(Database.of(list(paints(count=given.paints).values())), given.folder / "fit_solvers.png")
    plot_samples(given.paints, given.folder / "fit_samples.png")


if __name__ == "__main__":
    main()
