"""Path-trace the packaged environments that are scenes; needs Mitsuba (the part ``reference``)::

    python packaging/generators/traced_environments.py [street] [photo_studio] [light_tunnel] [--kept FOLDER]

At full size a scene takes from a quarter of an hour to hours. With ``--kept`` the sums of the samples are kept after
each pass, so that a call goes on where an earlier one ended, also with more samples or less noise.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

from environments.scenes import SCENES, trace

HEIGHT = 1024
SAMPLES = 512
NOISE = 0.02
RESOURCES = Path(__file__).resolve().parents[2] / "resources"


def generate(
    folder: Path,
    names: Sequence[str] = (),
    height: int = HEIGHT,
    samples: float = SAMPLES,
    noise: float = NOISE,
    kept: Path | None = None,
    save_every_s: float = 240.0,
) -> Iterator[Path]:
    """Write the named environments, or all, and yield each file when it is done; now and then it is written before."""
    for name in names or SCENES:
        path = folder / f"{name}.exr"
        start = saved = time.perf_counter()
        for picture in trace(name, height, samples, noise, kept):
            now = time.perf_counter()
            print(
                f"{name}: {picture.samples:.1f} paths, noise {100 * picture.noise:.2f} %, on a twentieth over "
                f"{100 * picture.most_noise:.1f} %, {now - start:.0f} s",
                flush=True,
            )
            if picture.is_last or now - saved > save_every_s:
                picture.write(path)
                saved = now
        yield path


def main() -> int:
    """Write the environments that the command line names."""
    parser = argparse.ArgumentParser(description="Path-trace the packaged environments that are scenes.")
    parser.add_argument(
        "names", nargs="*", metavar="NAME", help=f"any of {', '.join(SCENES)}; none means all"
    )
    parser.add_argument("--output", type=Path, default=RESOURCES / "environments", help="folder of the maps")
    parser.add_argument("--height", type=int, default=HEIGHT, help="rows of a map")
    parser.add_argument(
        "--samples",
        type=float,
        default=SAMPLES,
        help="the most paths a pixel of a light, in the mean",
    )
    parser.add_argument(
        "--noise", type=float, default=NOISE, help="relative noise that is aimed at everywhere"
    )
    parser.add_argument("--kept", type=Path, help="folder in which the sums are kept")
    options = parser.parse_args()
    unknown = sorted(set(options.names) - set(SCENES))
    if unknown:
        parser.error(f"{unknown[0]!r} is none of {', '.join(SCENES)}")
    options.output.mkdir(parents=True, exist_ok=True)
    if options.kept is not None:
        options.kept.mkdir(parents=True, exist_ok=True)
    for path in generate(
        options.output, options.names, options.height, options.samples, options.noise, options.kept
    ):
        print(f"{path.name}: {path.stat().st_size / 1e6:.2f} MB", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
