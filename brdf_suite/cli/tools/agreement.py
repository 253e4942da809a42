"""``brdf-suite agreement``: the real-time picture against the path-traced one, with figures, pictures and a page."""

from __future__ import annotations

import argparse
import math
from dataclasses import replace

from brdf_suite.cli.arguments import add_arguments, add_json, add_output
from brdf_suite.cli.fit_options import add_fitting, parse_fitting
from brdf_suite.cli.output import print_csv, print_done, print_json, progress_bar
from brdf_suite.cli.picture.reference_options import samples
from brdf_suite.command_parser import CommandParser
from brdf_suite.extras import import_extra
from brdf_suite.pipeline.material import paint_names
from brdf_suite.pipeline.scene import environment_names
from brdf_suite.progress import subrange
from brdf_suite.tracing.agreement.forms import DEFAULT_FORM, FORMS


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Render paints in environments on a sphere with both renderers; print ΔE00 and FLIP by effect, and "
        "with -o write a page with pictures. What is path-traced can be kept, and is then not traced again."
    )
    add_arguments(
        command,
        {
            "--paints PAINT...": "default: all shipped designed paints",
            "--environments FILE|NAME...": "default: all shipped environments",
            "--mesh FILE|NAME...": "the surfaces, each reported separately (default: sphere); all but the first in the "
            "shipped environments, where one is among those given",
            "--forms FORM...": f"ways to draw, of {', '.join(FORMS)} (default: all; of further surfaces "
            f"{DEFAULT_FORM} alone)",
            "--size WxH=128x128": "pixels (default: 128x128)",
            "--spp N=512": "samples a pixel of each of the two traces (default: 512)",
            "--noise DELTA_E": "trace on, up to 64 times as long, until the two traces of each case differ by a mean "
            "ΔE00 of at most this (default: no bound)",
            "--flakes": "also compare with single flakes, every paint that has them, by means over 16×16 pixels and "
            "eight populations of flakes",
            "--lobes": "trace the fitted lobes too: separates the fit's error from the look-up's",
            "--keep FOLDER": "keep what is traced in this folder",
        },
        forms=tuple(FORMS),
        spp=samples,
        noise=_bound,
    )
    command.examples = ("brdf-suite agreement --paints blue --environments booth -o agreement.md",)
    add_output(command, "a page (.md) to write; its pictures go into images/ beside it", required=False)
    add_json(command, csv=True)
    add_fitting(command)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Compare; print a table or a JSON object, and write the page."""
    # Named first: it is found out sooner.
    import_extra("flip_evaluator", purpose="the comparison of pictures")
    from brdf_suite.tracing.agreement.comparison import Case, Order, compare, judged_form, summary
    from brdf_suite.tracing.agreement.flakes import FlakeCase, check_size, compare_flakes
    from brdf_suite.tracing.agreement.page import check_page, drawn_forms, groups, write_page

    if options.output is not None:
        check_page(options.output)
    if options.flakes:
        check_size(options.size)
    given = options.environments or environment_names()
    surfaces = options.mesh or ["sphere"]
    first = Order(
        paints=options.paints or paint_names(),
        environments=given,
        size=options.size,
        samples=options.spp,
        noise=options.noise,
        forms=options.forms or tuple(FORMS),
        lobes=options.lobes,
        surface=surfaces[0],
        keep=options.keep,
        fitting=parse_fitting(options),
    )
    shipped = [name for name in given if name in environment_names()]
    further = replace(
        first, environments=shipped or given, forms=options.forms or (DEFAULT_FORM,), lobes=False
    )
    orders = [first, *(replace(further, surface=mesh) for mesh in surfaces[1:])]
    cases: list[Case] = []
    flakes: list[FlakeCase] = []
    with progress_bar("comparing", quiet=options.json) as progress:
        for number, order in enumerate(orders):
            step = subrange(progress, number / len(orders), (number + 1) / len(orders))
            cases += compare(order, subrange(step, 0.0, 0.5 if options.flakes else 1.0))
            if options.flakes:
                flakes += compare_flakes(order, subrange(step, 0.5, 1.0))
    if options.output is not None:
        write_page(options.output, cases, first, flakes)
    if options.json:
        print_json(
            {
                "summary": {
                    title: {form: summary(group, form) for form in drawn_forms(group)}
                    for title, group in groups(cases)
                },
                "cases": [case.to_json() for case in cases],
                "flakes": [case.to_json() for case in flakes],
            }
        )
        return 0
    if options.csv:
        print_csv(
            {
                "paint": case.paint,
                "environment": case.environment,
                "form": form,
                "delta_e_mean": error.mean,
                "delta_e_p99": error.p99,
                "flip": error.flip,
                "noise": case.noise.mean,
            }
            for case in cases
            for form, error in case.errors.items()
        )
        return 0
    print(f"{'paint':24} {'environment':18} {'ΔE00':>6} {'99 %':>6} {'FLIP':>6} {'noise':>6}  form")
    for case in cases:
        form = judged_form(case.errors)
        e = case.errors[form]
        print(
            f"{case.paint[:24]:24} {case.environment[:18]:18} {e.mean:6.2f} {e.p99:6.2f} {e.flip:6.3f} "
            f"{case.noise.mean:6.2f}  {form}"
        )
    for title, group in groups(cases):
        print(title)
        for form in drawn_forms(group):
            s = summary(group, form)
            print(
                f"  {form}: mean ΔE00 {s['de00_mean']:.2f}, worst paint {s['de00_worst']:.2f}, "
                f"99th percentile {s['de00_p99']:.2f}, FLIP {s['flip']:.3f}"
            )
    if flakes:
        print("With flakes, means of 16×16 pixels over eight populations: mean ΔE00, worst, noise, luminance")
    for shown in flakes:
        print(
            f"  {shown.paint[:24]:24} {shown.environment[:18]:18} {shown.surface[:12]:12} {shown.de00_mean:6.2f} "
            f"{shown.de00_worst:6.2f} {shown.noise:6.2f} {shown.luminance:6.3f}"
        )
    if options.output is not None:
        print_done(f"{options.output}: written")
    return 0


def _bound(text: str) -> float:
    try:
        bound = float(text)
    except ValueError:
        bound = math.nan
    if not 0.01 <= bound <= 100.0:
        raise argparse.ArgumentTypeError(f"{text!r} is not a colour difference from 0.01 to 100")
    return bound
