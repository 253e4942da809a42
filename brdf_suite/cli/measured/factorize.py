"""``brdf-suite factorize PAINT -o FILE``: any reflectance as a product of textures."""

from __future__ import annotations

import argparse
from pathlib import Path

from brdf_suite.cli.arguments import PAINT, add_arguments, add_json, add_output
from brdf_suite.cli.output import print_done, print_json, progress_bar
from brdf_suite.command_parser import CommandParser
from brdf_suite.documents.atomic import check_target
from brdf_suite.documents.store import PAINT_ENDING
from brdf_suite.errors import FileError, FittingError
from brdf_suite.fitting.homomorphic.factorization import SYMMETRIC
from brdf_suite.fitting.homomorphic.reflectance_fit import (
    TABLE_ENDING,
    FactoredFit,
    FactoringOptions,
    factor_reflectance,
    save_factored,
)
from brdf_suite.pipeline.material import load_material
from brdf_suite.progress import report, subrange


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Factor a reflectance into a product of maps, f_r = alpha p(wo) q(h) p(wi) or any other, by least "
        "squares of the logarithm (McCool, Ang and Ahmad 2001), with the specular peak apart, and report how near the "
        "product comes. The paint or table that is written opens in all programs."
    )
    command.examples = (
        "brdf-suite factorize cayman.brdf -o cayman.brdfpaint",
        'brdf-suite factorize brushed.bsdf -o brushed.brdfpaint --factors "p:wo q:h p:wi" --resolution 64',
    )
    add_arguments(command, {"reflectance PAINT": PAINT})
    add_output(command, "the .brdfpaint to write, its textures in an .exr beside it, or a .brdftable")
    add_factoring(command)
    add_arguments(command, {"--overwrite": "replace FILE where it is there"})
    add_json(command)
    command.set_defaults(run=run)


def add_factoring(command: CommandParser) -> None:
    """Declare the options read by :func:`parse_factoring`."""
    add_arguments(
        command,
        {
            "--factors WORDS": 'the maps and what each is read by, "map:projection ...", a map twice if it is read '
            'twice, "@n" behind it for its texels; projections: wi, wo, h, |wi|, |wo|, |h|, sqrt|h|, w.h, wi.wo, '
            'w.h,h.n and wi.n,wo.n; default: "p:|wo| q:sqrt|h| p:|wi| d:w.h@16" of what is isotropic, else "p:wo '
            'q:h p:wi"',
            "--resolution N=32": "texels along a map, 2 to 512; default: 32",
            "--smoothness L": "weight of the maps' Laplacian beside a sample's; default: 4 of measured files, 1 of "
            "paints",
            "--bias E": "what is added to each value, over their mean, as an error of measurement; default: 1e-2 of "
            "measured files, 1e-5 of paints",
            "--peak {auto,off,radial,map}=auto": "keep the specular peak apart, over the half vector's radius or as "
            "a map; default: auto, radial of what is isotropic",
            "--keep-mean {auto,on,off}=auto": "scale the product so that it reflects as much as the samples do; "
            "default: auto, where that brings it no farther from them",
            "--radial": "keep maps of two axes that are radially symmetric within 2 %% as their radius alone",
            "--pairs N=57600": "pairs of directions that are drawn of a paint; default: 57600",
        },
    )


def parse_factoring(options: argparse.Namespace) -> FactoringOptions:
    """Return the settings that the options ask for."""
    return FactoringOptions(
        factors=options.factors,
        resolution=options.resolution,
        smooth=options.smoothness,
        bias=options.bias,
        peak=options.peak,
        keep_mean=options.keep_mean,
        radial=options.radial,
        pairs=options.pairs,
    )


def run(options: argparse.Namespace) -> int:
    """Factor, write the paint and print a summary."""
    if options.output.suffix.lower() not in (PAINT_ENDING, TABLE_ENDING):
        raise FileError(
            options.output,
            f"a product of textures goes into a {PAINT_ENDING} or a {TABLE_ENDING}; give it one of these endings",
        )
    check_target(options.output, overwrite=options.overwrite)
    with progress_bar("factoring", quiet=options.json) as progress:
        report(progress, 0.0, "reading")
        material = load_material(options.reflectance)
        try:
            found = factor_reflectance(
                material.name,
                material.reflectance,
                parse_factoring(options),
                progress=subrange(progress, 0.1, 1.0),
            )
        except FittingError as error:
            raise FittingError(f"{material.name}: {error}") from error
    save_factored(found, options.output)
    if options.json:
        print_json({**found.to_json(), "file": str(options.output)})
    else:
        print_done(_summary(found, options.output))
    return 0


def _summary(found: FactoredFit, output: Path) -> str:
    near = found.accuracy
    peak = f", peak apart: {found.peak}" if found.peak else ""
    lines = [f"{found.name}: {found.samples:,} samples, {found.factors}{peak}, {found.solver}"]
    if found.left_out or found.raised:
        lines.append(f"left out: {found.left_out:,} samples; negative ones taken for 0: {found.raised:,}")
    lines.append(f"relative error: median {near.median_relative:.3f}; SNR {near.snr_db:.2f} dB")

    symmetric = [name for name, size in found.asymmetry.items() if size <= SYMMETRIC]
    if symmetric:
        verb = "is" if len(symmetric) == 1 else "are"
        lines.append(f"{' and '.join(symmetric)} {verb} radially symmetric; --radial keeps the radius alone")
    lines.append(f"{found.compression:.3g} samples a texel; written to {output}")
    return "\n".join(lines)
