"""``brdf-suite sheet PAINT|PALETTE… -o out.png|out.pdf``: contact sheet of paints in the same light, with figures."""

from __future__ import annotations

import argparse
from pathlib import Path

from brdf_suite.cli.arguments import PAINTS, add_arguments, add_cmyk_profile, add_export, add_output
from brdf_suite.cli.output import export_progress, print_written
from brdf_suite.cli.picture.scene_options import add_picture, add_scene, parse_settings, parse_view
from brdf_suite.command_parser import CommandParser
from brdf_suite.palettes.swatches.look import RENDERED, SwatchLook
from brdf_suite.reports.contact_sheet.document import write_sheet
from brdf_suite.reports.contact_sheet.page_layout import FIELDS, PageStyle


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Render every paint of a palette (of any format that palette info reads) or of a folder on the "
        "same surface in the same light, each with its name, flop index and L*a*b* at 15, 45 and 110°."
    )
    command.examples = (
        "brdf-suite sheet summer.brdfpalette -o summer.pdf --page a4 --landscape",
        "brdf-suite sheet blue red copper -o three.png --form sphere",
    )
    add_arguments(command, {"sources PAINT|PALETTE...": PAINTS}, sources=Path)
    add_output(command, "the sheet (.png or .pdf)", stream=".png")
    add_arguments(
        command.add_argument_group("sheet"),
        {
            "--columns N": "in a row (default: a sheet of 4 to 3)",
            "--form {surface,sphere,panel,chips,flop_strip}=surface": "the picture of a paint: --mesh in its "
            "surroundings, a sphere or a curved panel before mid grey as Color Swatch has it, bands of its colours at "
            "15, 45 and 110°, or the strip of its flop (default: surface)",
            "--page {a4,a3,letter}=a4": "the paper of a PDF (default: a4)",
            "--landscape": "lay the paper on its side",
            "--show FIELDS": "what stands below the pictures of a PDF, by commas: code, colours (chips at 15, 45 and "
            "110°), figures (flop index and gloss), lab (default: all)",
        },
    )
    add_cmyk_profile(command)
    add_scene(command, (360, 240))
    add_picture(command, radiance=False, sheet=True)
    add_export(command)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Render and write; print a line or a JSON object. 1 where a paint could not be drawn."""
    view = parse_view(options)
    if options.form in RENDERED:
        view = SwatchLook(form=options.form, environment=view.environment).view()
    shown = FIELDS if options.show is None else tuple(filter(None, options.show.split(",")))
    style = PageStyle(options.page, options.landscape, fields=shown)
    with export_progress("sheet", options) as progress:
        made = write_sheet(
            options.sources,
            view,
            options.size,
            options.output,
            options.columns,
            parse_settings(options),
            form=options.form if options.form in ("chips", "flop_strip") else None,
            style=style,
            cmyk_profile=options.cmyk_profile,
            progress=progress,
        )
    size = f"{made.pages} pages" if made.pages else f"{made.width}×{made.height}"
    problems = [f"not drawn: {problem}" for problem in made.problems]
    lines = [*problems, f"{made.path}: {made.paints} paints, {size}"]
    print_written(made, "\n".join(lines), as_json=options.json)
    return 1 if made.problems else 0
