"""``brdf-suite project``: pack, list, collect and unpack projects."""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

from brdf_suite.cli.arguments import add_arguments, add_json, add_output
from brdf_suite.cli.output import print_csv, print_done, print_json
from brdf_suite.command_parser import CommandParser
from brdf_suite.documents.project import (
    NamedView,
    Project,
    ProjectPicture,
    load_project,
    project_parts,
    project_references,
    project_to_json,
    save_project,
)
from brdf_suite.documents.store import AnyPaint, load_view
from brdf_suite.documents.studio import load_light
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.pipeline.material import load_document
from brdf_suite.regular_files import exists, is_folder


def add(command: CommandParser) -> None:
    """Declare the command and its parts."""
    command.description = (
        "A .brdfproject holds paints, a standard, views, lights, a measured source and the settings of pictures "
        "in one zip file or folder; collected, also the files that they name."
    )
    parts = command.add_subparsers(dest="part", metavar="pack|list|collect|unpack", required=True)
    pack = parts.add_parser("pack", help="make a project of documents")
    command.examples = (
        "brdf-suite project pack --paint blue -o mine.brdfproject",
        "brdf-suite project list --help",
    )
    pack.examples = (
        "brdf-suite project pack --paint red.brdfpaint --view day.brdfview -o spring.brdfproject",
    )
    add_output(pack, "the .brdfproject to write", stream=".brdfproject")
    add_arguments(
        pack,
        {
            "--name NAME": "default: the name of FILE",
            "--notes TEXT": "notes of the project",
            "--standard PAINT": "what the paints are judged against",
            "--source FILE": "the measured file that the design started from",
            "--collect": "copy the files that views and source name into the project",
            "--folder": "write a folder instead of a zip file",
        },
    )
    add_json(pack)
    for flag, word, text in (
        ("--paint", "PAINT", "a paint's file or name, the main one first; may be given again"),
        ("--view", "FILE", "a .brdfview file; may be given again"),
        ("--light", "FILE", "a .brdfstudio file; may be given again"),
        ("--picture", "VIEW:WxH", "a picture of a view that is packed, by its name; may be given again"),
    ):
        pack.add_argument(flag, metavar=word, action="append", default=[], help=text)
    pack.set_defaults(run=run_pack)
    listed = parts.add_parser("list", help="say what a project holds")
    listed.examples = ("brdf-suite project list spring.brdfproject",)
    add_arguments(listed, {"project FILE": "a project, zip file or folder"})
    add_json(listed, csv=True)
    listed.set_defaults(run=run_list)
    collect = parts.add_parser("collect", help="write a project with the files that it names")
    add_arguments(
        collect,
        {
            "project FILE": "a project",
            "--folder": "write a folder instead of a zip file",
        },
    )
    collect.examples = ("brdf-suite project collect spring.brdfproject -o whole.brdfproject",)
    add_output(collect, "the project to write", stream=".brdfproject")
    add_json(collect)
    collect.set_defaults(run=run_collect)
    unpack = parts.add_parser("unpack", help="make a folder of a project")
    unpack.examples = ("brdf-suite project unpack whole.brdfproject -o spring",)
    add_arguments(unpack, {"project FILE": "a project"})
    add_output(unpack, "a new or empty folder")
    add_json(unpack)
    unpack.set_defaults(run=run_unpack)


def run_pack(options: argparse.Namespace) -> int:
    """Make a project and print a line or a JSON object."""
    views = tuple(NamedView(Path(file).stem, load_view(file)) for file in options.view)
    project = Project(
        options.name or options.output.stem,
        tuple(_paint(name) for name in options.paint),
        None if options.standard is None else _paint(options.standard),
        views,
        tuple(load_light(file) for file in options.light),
        "" if options.source is None else str(Path(options.source).absolute()),
        tuple(_picture(text) for text in options.picture),
        options.notes or "",
    )
    collected = save_project(project, options.output, collect=options.collect, folder=options.folder)
    return _print(project, str(options.output), collected, as_json=options.json)


def run_list(options: argparse.Namespace) -> int:
    """Print what a project holds; nothing is unpacked."""
    parts = project_parts(options.project)
    project = load_project(options.project)
    if options.json:
        print_json(
            {
                **project_to_json(project),
                "files": [{"name": name, "bytes": size} for name, size in parts],
                "references": list(project_references(project)),
            }
        )
        return 0
    rows = [
        ("paint", [paint.name for paint in project.paints]),
        ("standard", [] if project.standard is None else [project.standard.name]),
        ("view", [view.name for view in project.views]),
        ("light", [light.name for light in project.lights]),
        ("source", [project.source] if project.source else []),
        ("picture", [f"{one.name}, {one.width}×{one.height} of {one.view}" for one in project.pictures]),
        ("collected", [f"{name}, {size:,} bytes" for name, size in parts]),
        ("named", [path for path in project_references(project) if path != project.source]),
    ]
    if options.csv:
        print_csv({"kind": word, "name": name} for word, names in rows for name in names)
        return 0
    print(f"{project.name}")
    for word, names in rows:
        for name in names:
            print(f"{word:>10}  {name}")
    return 0


def run_collect(options: argparse.Namespace) -> int:
    """Write a project again with everything that it names."""
    with tempfile.TemporaryDirectory(prefix="brdf-project-") as scratch:
        project = load_project(options.project, scratch)
        collected = save_project(project, options.output, collect=True, folder=options.folder)
    return _print(project, str(options.output), collected, as_json=options.json)


def run_unpack(options: argparse.Namespace) -> int:
    """Make a folder of a project; its files become files of the folder."""
    folder = Path(options.output)
    if exists(folder) and (not is_folder(folder) or any(folder.iterdir())):
        raise FileError(folder, "is not an empty folder; name a new one")
    project = load_project(options.project, folder)
    # What was unpacked is named within the folder; what lies elsewhere stays there.
    inside = save_project(project, folder, folder=True)
    return _print(project, str(folder), inside, as_json=options.json)


def _print(project: Project, path: str, collected: tuple[str, ...], *, as_json: bool) -> int:
    if as_json:
        counts = {name: len(getattr(project, name)) for name in ("paints", "views", "lights", "pictures")}
        print_json({"path": path, "name": project.name, **counts, "collected": list(collected)})
        return 0
    print_done(
        f"{path}: {project.name}, {len(project.paints)} paints, {len(project.views)} views, "
        f"{len(project.lights)} lights, {len(project.pictures)} pictures, {len(collected)} files collected"
    )
    return 0


def _paint(name: str) -> AnyPaint:
    found = load_document(name)
    if found is None:
        raise SuiteError(f"{name}: is no paint document; give a measured file as --source")
    return found


def _picture(text: str) -> ProjectPicture:
    view, _, size = text.rpartition(":")
    width, _, height = size.partition("x")
    if not (view and width.isdecimal() and height.isdecimal()):
        raise SuiteError(f"--picture: expected VIEW:WIDTHxHEIGHT, not {text!r}")
    return ProjectPicture(view, view, int(width), int(height))
