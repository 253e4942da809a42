"""``brdf-suite factorize FILE|PAINT -o OUT.brdftable``: anything that reflects as a product of textures."""

from __future__ import annotations

import argparse
from pathlib import Path

from brdf_suite.cli.output import print_json, progress_bar


def add(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Declare the command."""
    command = commands.add_parser(
        "factorize",
        help="write anything that reflects as a product of textures",
        description="Factor a reflectance into f_r = alpha p(wo) q(h) p(wi), p and q maps over the hemisphere, by "
        "least squares of the logarithm (McCool, Ang and Ahmad 2001), and tell how near the product comes. The file "
        "is opened wherever a measured one is.",
    )
    command.add_argument(
        "reflectance", metavar="FILE|PAINT", help="a measured file, a .brdfpaint file, or the name of a paint"
    )
    command.add_argument(
        "-o", "--output", metavar="OUT", type=Path, required=True, help="the .brdftable to write"
    )
    command.add_argument(
        "--resolution", metavar="N", type=int, default=32, help="texels along a map, 2 to 512; default: 32"
    )
    command.add_argument(
        "--smoothness",
        metavar="L",
        type=float,
        default=0.1,
        help="weight of the maps' Laplacian beside a sample's; default: 0.1",
    )
    command.add_argument(
        "--bias",
        metavar="E",
        type=float,
        default=1e-5,
        help="what is added to each value, over their mean, as an error of measurement; 1e-3 suits noisy files; "
        "default: 1e-5",
    )
    command.add_argument(
        "--pairs",
        metavar="N",
        type=int,
        default=57_600,
        help="pairs of directions that are drawn of a paint; default: 57600",
    )
    command.add_argument("--json", action="store_true", help="print one JSON object")
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Factor, write and tell."""
    from brdf_suite.errors import FileError
    from brdf_suite.files.measured.brdftable import write_brdftable
    from brdf_suite.pipeline.factoring import factor_any

    if options.output.suffix.lower() != ".brdftable":
        raise FileError(options.output, "a product of textures goes into a .brdftable; give it that ending")
    with progress_bar("factoring", quiet=options.json) as progress:
        found = factor_any(
            options.reflectance,
            resolution=options.resolution,
            smooth=options.smoothness,
            bias=options.bias,
            pairs=options.pairs,
            progress=progress,
        )
    write_brdftable(found.value, options.output)
    if options.json:
        print_json({**found.to_json(), "file": str(options.output)})
        return 0
    near = found.accuracy
    print(
        f"{found.name}: {found.samples:,} samples, {options.resolution}×{options.resolution} texels, {found.solver}"
    )
    if found.left_out or found.raised:
        print(f"left out: {found.left_out:,} samples; negative ones taken for 0: {found.raised:,}")
    print(
        f"relative error: median {near.median_relative:.3f}, mean {near.mean_relative:.3g}; SNR {near.snr_db:.2f} dB"
    )
    print(f"{found.compression:.0f} samples a texel; written to {options.output}")
    return 0
