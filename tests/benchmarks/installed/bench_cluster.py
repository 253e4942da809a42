"""A batch on a cluster of processes whose worker, and then whose scheduler, is killed, and the command run again."""

from __future__ import annotations

import tempfile
from collections import Counter
from pathlib import Path

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.progress import Progress, report

NAME = "cluster"
PAINTS, TURNS = 60, 5

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "items": (
        "",
        None,
        "",
        f"measured in {TURNS} batches of {PAINTS}, a worker and the scheduler killed in each",
    ),
    "lost": ("<=", 0.0, "", "items that are not in the results after the command ran again"),
    "twice": ("<=", 0.0, "", "items that are in the journal or the table more than once"),
    "done_before": ("", None, "", "items that the second command did not do again"),
}


def run(progress: Progress | None) -> dict[str, float | None]:
    """Kill, run again, and count what the results have."""
    parts = load_module(Path(__file__).resolve().parents[2] / "killed_cluster.py")
    figures: dict[str, float | None] = dict.fromkeys(BOUNDS, 0.0)
    found: Counter[str] = Counter()
    for turn in range(TURNS):
        report(progress, turn / TURNS, "killing a worker and the scheduler")
        with tempfile.TemporaryDirectory() as name, parts.cluster_of_two(Path(name)) as cluster:
            folder, out = Path(name), Path(name, "out")
            palette = parts.make_palette(folder / "fleet.brdfpalette", PAINTS)
            parts.kill_worker_and_scheduler(cluster, palette, out)
            answer = parts.run_again(cluster, palette, out)
            keys = Counter(line["key"] for line in parts.lines_of(out))
            rows = (out / "results.csv").read_text(encoding="utf-8").count("\n") - 1
        found["items"] += PAINTS
        found["lost"] += PAINTS - min(len(keys), rows)
        found["twice"] += sum(count - 1 for count in keys.values()) + max(0, rows - PAINTS)
        found["done_before"] += answer["done_before"]
    return figures | {key: float(found[key]) for key in BOUNDS}
