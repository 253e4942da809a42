"""``brdf-suite environment info FILE``: size, layout, notes and figures of an environment."""

from __future__ import annotations

import argparse
import dataclasses

from brdf_suite.cli.output import print_json, print_notes
from brdf_suite.cli.picture.scene_options import add_environment
from brdf_suite.lighting.statistics import EnvironmentStatistics, Histogram, environment_statistics
from brdf_suite.pipeline.environments import read_environment_file
from brdf_suite.pipeline.scene import find_environment

_BAR = 40
_ROWS = 20  # of the histogram; more stops than that are put together two by two, and so on


def add(actions: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Declare the action."""
    action = actions.add_parser(
        "info",
        help="its size and layout, how bright and uneven it is, where its sun stands, a histogram",
        description="Print what an environment is. Radiances are in the file's own units, colours linear Rec. 2020.",
    )
    add_environment(action)
    action.add_argument("--json", action="store_true", help="print one JSON object")
    action.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Read, count and print."""
    name, path = find_environment(options.environment)
    read = read_environment_file(path, options.layout)
    environment = read.environment
    statistics = environment_statistics(environment)
    rows, columns = environment.radiance.shape[:2]
    if options.json:
        print_json(
            {
                "environment": name,
                "layout": read.layout,
                "image_width": read.image_width,
                "image_height": read.image_height,
                "width": columns,
                "height": rows,
                "notes": list(environment.notes),
                "content_hash": environment.content_hash,
                **dataclasses.asdict(statistics),
            }
        )
        return 0
    unfolded = f", as a map {columns:,} × {rows:,}" if read.layout not in ("latlong", "studio", "sky") else ""
    print(f"{name}: {read.image_width:,} × {read.image_height:,} pixels, layout {read.layout}{unfolded}")
    print_notes(environment.notes)
    for title, value in facts(statistics):
        print(f"  {title:<24}{value}")
    print("\nshare of the sphere by luminance (log2)")
    for line in bars(statistics.histogram):
        print(f"  {line}")
    return 0


def facts(statistics: EnvironmentStatistics) -> list[tuple[str, str]]:
    """Return title and value of each figure, for a table."""
    red, green, blue = statistics.average_radiance
    front, right, back, left = statistics.vertical_illuminance
    stops = statistics.dynamic_range_stops
    if statistics.sun_elevation_deg is None:
        sun = "none: the light is even"
    else:
        sun = (
            f"{statistics.sun_elevation_deg:.2f}° above the horizon, azimuth {statistics.sun_azimuth_deg:.2f}° "
            f"from +z towards +x; {100.0 * statistics.sun_share:.1f} % of all light"
        )
    return [
        (
            "average radiance",
            f"{red:.4g} {green:.4g} {blue:.4g}   luminance {statistics.average_luminance:.4g}",
        ),
        ("illuminance from above", f"{statistics.horizontal_illuminance:.4g}"),
        ("illuminance of walls", f"+z {front:.4g}   -x {right:.4g}   -z {back:.4g}   +x {left:.4g}"),
        ("brightest", f"{statistics.brightest_luminance:.4g}"),
        ("dynamic range", "1 % of the sphere or more is black" if stops is None else f"{stops:.1f} stops"),
        ("sun or strongest lamp", sun),
    ]


def bars(histogram: Histogram) -> list[str]:
    """Return the histogram as lines: the lower edge of each step, a bar, its share; the brightest first."""
    shares = list(histogram.shares)
    together = -(-len(shares) // _ROWS) if shares else 1
    steps = [
        (histogram.lowest_stop + first, sum(shares[first : first + together]))
        for first in range(0, len(shares), together)
    ]
    most = max([share for _, share in steps] + [histogram.black, 1e-12])
    lines = []
    for stop, share in reversed(steps):
        bar = "#" * max(round(_BAR * share / most), 1 if share > 0.0 else 0)
        lines.append(f"{stop:+5.0f}  {bar:<{_BAR}} {_percent(share)}")
    if histogram.black > 0.0005:
        lines.append(
            f"black  {'#' * max(1, round(_BAR * histogram.black / most)):<{_BAR}} {_percent(histogram.black)}"
        )
    return lines


def _percent(share: float) -> str:
    return f"{100.0 * share:8.4f} %" if 0.0 < share < 0.001 else f"{100.0 * share:6.2f} %"
