"""``brdf-suite batch STEP PAINT|PALETTE|FOLDER… -o FOLDER``: one step with thousands of paints."""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Callable
from pathlib import Path

from brdf_suite.batches.items import list_lights, list_paints, sources_in
from brdf_suite.batches.running import MOST_IN_A_GROUP, BatchResult, run_batch
from brdf_suite.batches.steps import BatchStep, Export, Factorize, Fit, Measure, Prefilter, Render
from brdf_suite.batches.workers import JOB_SYSTEMS, start_workers
from brdf_suite.cli.arguments import add_arguments, add_format, add_json, whole_number
from brdf_suite.cli.fit_options import add_basis, add_fitting, parse_basis, parse_fitting
from brdf_suite.cli.measured.factorize import add_factoring, parse_factoring
from brdf_suite.cli.measured.measure import APERTURE_HELP, GEOMETRY_HELP, add_no_texture
from brdf_suite.cli.output import print_done, print_json, print_notes, print_problems, progress_bar
from brdf_suite.cli.picture.scene_options import (
    add_environment_layout,
    add_picture,
    add_scene,
    parse_settings,
    parse_view,
)
from brdf_suite.command_parser import CommandParser
from brdf_suite.errors import SuiteError
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.regular_files import read_text
from brdf_suite.reports.handover import formats

_MOST_PROBLEMS = 20


def add(command: CommandParser) -> None:
    """Declare the command and its steps."""
    command.description = (
        "Do one step with every paint of palettes, folders, lists and names: on all cores, or on a Dask cluster. The "
        "folder of the results gets a table (CSV and Parquet), a palette, pictures or other files, and summary.html. A "
        "batch that was stopped goes on where it was when the same command is run again; an item that fails is "
        "reported and left out. Needs the extra `batches`."
    )
    command.examples = (
        "brdf-suite batch measure fleet.brdfpalette -o measured",
        "brdf-suite batch render paints/ -o pictures --size 320x240 --workers 4",
    )
    steps = command.add_subparsers(
        dest="step", metavar="measure|fit|render|prefilter|factorize|export", required=True
    )
    measure = _step(
        steps,
        "measure",
        "read with the virtual instruments",
        lambda o: Measure(o.geometry, o.aperture, o.texture),
    )
    measure.add_argument("--geometry", default="six", metavar="NAME", help=GEOMETRY_HELP)
    measure.add_argument("--aperture", default="point", metavar="DEG", help=APERTURE_HELP)
    add_no_texture(measure)
    measure.examples = ("brdf-suite batch measure blue copper -o measured --workers 1",)
    fit = _step(steps, "fit", "fit the cosine lobes", lambda o: Fit(parse_fitting(o)))
    add_fitting(fit)
    fit.examples = ("brdf-suite batch fit blue copper -o fitted --workers 1",)
    render = _step(steps, "render", "render on a surface in an environment", _render)
    add_scene(render, (640, 360))
    add_picture(render)
    render.examples = (
        "brdf-suite batch render paints/ -o pictures --size 320x240 --environment sunny",
        "brdf-suite batch render --list autumn.txt -o pictures --scheduler tcp://10.0.0.5:8786",
    )
    add_arguments(render, {"--exr": "write radiance as OpenEXR instead of PNG"})
    prefilter = _step(
        steps,
        "prefilter",
        "filter environments into the cache",
        lambda o: Prefilter(FitSettings(parse_basis(o)), o.layout),
        "an .exr or .hdr map, a .brdfstudio file, a shipped name; a folder stands for all below it",
        "FILE|NAME|FOLDER",
    )
    add_environment_layout(prefilter)
    add_basis(prefilter)
    prefilter.examples = ("brdf-suite batch prefilter environments/ -o filtered",)
    factorize = _step(
        steps, "factorize", "factor into products of textures", lambda o: Factorize(parse_factoring(o))
    )
    add_factoring(factorize)
    factorize.examples = ("brdf-suite batch factorize measured/ -o factors --resolution 64",)
    export = _step(
        steps, "export", "write in another program's format, a file each", lambda o: Export(o.format)
    )
    add_format(export, {known.name: (known.ending,) for known in formats()})
    export.examples = ("brdf-suite batch export fleet.brdfpalette -o materials --format gltf",)
    export.set_defaults(format="cxf")
    command.set_defaults(run=run)


def _step(
    steps: argparse._SubParsersAction[CommandParser],
    name: str,
    summary: str,
    make: Callable[[argparse.Namespace], BatchStep],
    sources: str = "a name, a paint, a measured file, a palette of any format; a folder stands for all below it",
    metavar: str = "PAINT|PALETTE|FOLDER",
) -> CommandParser:
    part = steps.add_parser(name, help=summary, description=summary[:1].upper() + summary[1:] + ".")
    part.add_argument("sources", metavar=metavar, nargs="*", help=sources)
    part.add_argument(
        "-o", "--output", metavar="FOLDER", type=Path, required=True, help="the folder of the results"
    )
    add_arguments(
        part.add_argument_group("batch"),
        {
            "--list FILE": "a text file with one source a line, # before a remark; - is standard input",
            "--workers N": "processes on this machine, or workers asked of --jobs (default: one a core; 1)",
            "--memory SIZE": "the most that a process on this machine may take, as 2GB (default: its share)",
            "--scheduler ADDRESS": "use the Dask cluster of this scheduler, tcp://HOST:PORT; its workers must see "
            "the sources and the results",
            "--jobs SYSTEM": "ask a job system for workers, by dask-jobqueue and its configuration file: "
            + ", ".join(JOB_SYSTEMS),
            "--group N": "items that a worker takes at once (default: two seconds of work)",
        },
        workers=whole_number(1, 4096),
        jobs=JOB_SYSTEMS,
        group=whole_number(1, MOST_IN_A_GROUP),
        list=str,
    )
    add_json(part)
    part.set_defaults(make=make)
    return part


def _render(options: argparse.Namespace) -> BatchStep:
    ending = ".exr" if options.exr else ".png"
    return Render(parse_view(options), options.size, ending, parse_settings(options))


def run(options: argparse.Namespace) -> int:
    """Run the batch; 1 where an item failed."""
    sources = [*options.sources, *(() if options.list is None else _listed(options.list))]
    if not sources:
        options.parser.error("name what the batch is to work on, or give --list FILE")
    step = options.make(options)
    items = (list_lights if step.name == "prefilter" else list_paints)(sources, options.output)
    with progress_bar(f"batch {step.name}", quiet=options.json) as progress:
        done = run_batch(
            step,
            items,
            options.output,
            lambda: start_workers(options.scheduler, options.jobs, options.workers, options.memory),
            group=options.group,
            progress=progress,
        )
    _print(done, as_json=options.json)
    return 1 if done.problems else 0


def _named(source: str, problem: str) -> str:
    """Return a problem with its source, which most begin with as it was given."""
    head = re.split("[:,]", problem, maxsplit=1)[0]
    return problem if head and source.endswith(head) else f"{source}: {problem}"


def _listed(file: str) -> list[str]:
    if not file:
        raise SuiteError("The name of the list is empty.")
    if file == "-":
        return sources_in(sys.stdin, Path())
    return sources_in(read_text(file).splitlines(), Path(file).parent)


def _print(done: BatchResult, *, as_json: bool) -> None:
    if as_json:
        print_json(
            {
                "output": str(done.folder),
                "step": done.step,
                "items": done.items,
                "done": done.done,
                "done_before": done.done_before,
                "other_items": done.others,
                "notes": list(done.notices),
                "problems": [{"source": source, "problem": problem} for source, problem in done.problems],
                "seconds": done.seconds,
            }
        )
        return
    shown = [_named(source, problem) for source, problem in done.problems]
    beyond = len(shown) - _MOST_PROBLEMS
    print_problems(shown[:_MOST_PROBLEMS] + ([f"{beyond:,} more, all in results.csv"] if beyond > 0 else []))
    print_notes(done.notices[:_MOST_PROBLEMS])
    if done.others:
        print_notes(
            [f"the folder holds {done.others:,} items of other batches; its table and page are of this one"]
        )
    more = f"; {len(shown):,} with a problem, all in results.csv" if shown else ""
    before = f", {done.done_before:,} done before" if done.done_before else ""
    items = f"{done.items:,} {'item' if done.items == 1 else 'items'}"
    print_done(f"{done.folder}: {items}{before}, {done.seconds:.1f} s{more}")
