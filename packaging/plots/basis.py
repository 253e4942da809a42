"""Draw the stored search as the paper's Figures 2 and 3 do: exponents per count, and errors per count.

    python packaging/plots/basis.py [FILE [FOLDER]]

FILE is the answer of ``brdf-suite basis``, by default the packaged one; the pictures go to docs/images.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt

ROOT = Path(__file__).resolve().parents[2]
STORED = ROOT / "resources" / "basis" / "search.json"
IMAGES = ROOT / "docs" / "images"
SIZE_INCHES = (6.4, 4.2)
DPI = 130


def draw(stored: Path, folder: Path) -> list[Path]:
    """Write both pictures into ``folder`` and return their paths."""
    answer = json.loads(stored.read_text(encoding="utf-8"))
    folder.mkdir(parents=True, exist_ok=True)
    return [_exponents(answer, folder / "basis_exponents.png"), _errors(answer, folder / "basis_errors.png")]


def _exponents(answer: dict, path: Path) -> Path:
    figure, axes = plt.subplots(figsize=SIZE_INCHES, layout="constrained")
    for row in answer["results"]:
        chosen = row["count"] == answer["default_count"]
        colour = "tab:red" if chosen else "tab:blue"
        axes.plot([row["count"]] * row["count"], row["exponents"], "o", ms=5, color=colour)
    axes.set_yscale("log")
    axes.set_xticks([row["count"] for row in answer["results"]])
    axes.set_xlabel("number of lobes (red: the default)")
    axes.set_ylabel("exponent")
    axes.grid(alpha=0.3, which="major")
    axes.set_title("Exponents found for each number of lobes")
    return _save(figure, path)


def _errors(answer: dict, path: Path) -> Path:
    rows = answer["results"]
    counts = [row["count"] for row in rows]
    figure, axes = plt.subplots(figsize=SIZE_INCHES, layout="constrained")
    axes.plot(
        counts, [row["equation_4"] for row in rows], "k-", marker="o", label="maximum + mean (equation 4)"
    )
    axes.plot(
        counts, [row["maximum"] for row in rows], "tab:red", marker="s", label="maximum over the paints"
    )
    axes.plot(counts, [row["mean"] for row in rows], "tab:blue", marker="^", label="mean over the paints")
    axes.axvline(answer["default_count"], color="0.6", ls="--", lw=1, label="the default")
    axes.set_yscale("log")
    ticks = [0.5, 1, 2, 5, 10, 20, 50]
    axes.set_yticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.minorticks_off()
    axes.set_xticks(counts)
    axes.set_xlabel("number of lobes")
    axes.set_ylabel("error (1: just seen)")
    axes.grid(alpha=0.3)
    axes.legend()
    axes.set_title("Error over the database")
    return _save(figure, path)


def _save(figure: plt.Figure, path: Path) -> Path:
    # No date inside: the same search gives the same bytes.
    figure.savefig(path, dpi=DPI, metadata={"Software": None})
    plt.close(figure)
    return path


def main() -> int:
    """Draw from and to what the command line names."""
    stored = Path(sys.argv[1]) if len(sys.argv) > 1 else STORED
    for path in draw(stored, Path(sys.argv[2]) if len(sys.argv) > 2 else IMAGES):
        print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
