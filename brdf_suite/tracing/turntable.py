"""A turntable by the path tracer or the ray tracer: frames are kept as they come, and gone on from."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Literal

from brdf_suite.arrays import Bytes
from brdf_suite.documents.atomic import check_target, make_folder, replacing, sync_folder
from brdf_suite.documents.store import view_to_json
from brdf_suite.documents.view import View
from brdf_suite.errors import FileError
from brdf_suite.files.bounded_reading import most_made_bytes
from brdf_suite.files.images.pictures import read_rgb
from brdf_suite.files.images.png import write_png
from brdf_suite.output.exposures import focused
from brdf_suite.output.turning import turned
from brdf_suite.output.turntable import Size, Turn, TurntableFiles, check_folder, framed_all_round
from brdf_suite.output.video import VIDEO_ENDINGS, check_video, ffmpeg, writing_video
from brdf_suite.pipeline.surface import load_shaped
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.realtime.camera import Bounds
from brdf_suite.reference.raytraced.quality import DEFAULT_PRESET
from brdf_suite.regular_files import exists, is_file, is_folder, read_bytes

if TYPE_CHECKING:
    from brdf_suite.reference.raytraced.table_split import TableSplit

TracedBy = Literal["reference", "raytraced"]
Draw = Callable[[View], tuple[Bytes, View]]
"""From a view to its picture as a screen shows it, and the view with its exposure measured."""
Started = tuple[Draw, str, tuple[str, ...]]
"""What draws a paint, its name, and sentences about it."""

REFERENCE_SAMPLES = 64
_STATE = "turntable.json"


@dataclass(frozen=True)
class Budget:
    """For each frame: ``quality`` of the ray tracer, ``samples`` a pixel (None: as many as usual).

    ``tables`` is how the ray tracer cuts the peak off a measured table.
    """

    quality: str = DEFAULT_PRESET
    samples: int | None = None
    tables: TableSplit = "clamp"


def write_traced_turntable(
    renderer: TracedBy,
    paint: str | os.PathLike[str],
    view: View,
    size: Size,
    path: Path,
    turn: Turn | None = None,
    budget: Budget | None = None,
    *,
    fresh: bool = False,
    progress: Progress | None = None,
) -> TurntableFiles:
    """Trace one turn of a paint (by name or file) and write it: .mp4 or .webm, or a new folder of PNG pictures.

    Finished frames are kept in the folder ``<path>.part``; the same call goes on from them, unless it is to begin
    ``fresh``. Automatic exposure is measured once, for the first frame, so that the light does not pump.

    Raises
    ------
    FileError
        A file cannot be read or written; the target is there and no empty folder; ffmpeg failed.
    ExtraError
        Mitsuba, or ffmpeg for a video, is missing or cannot be loaded.
    ReferenceUnavailableError
        LLVM is missing, or memory ran out.
    Cancelled
        The progress callback asked for it.
    """
    turn, budget = turn or Turn(), budget or Budget()
    video = path.suffix.lower() in VIDEO_ENDINGS
    if video:
        check_target(path)
        check_video(size)
        ffmpeg()
    else:
        check_folder(path)
    mesh = load_shaped(view.surface, view.surface_look)
    bounds = Bounds.of(p.positions for p in mesh.parts)
    shown = focused(framed_all_round(view, bounds, size), mesh, size)
    shown = replace(shown, clipping_marks=False, gamut_marks=False)
    shown = replace(shown, lens=replace(shown.lens, turn_deg=turn.blur_deg))
    report(progress, 0.0, "starting the renderer")
    begin = _reference if renderer == "reference" else _raytraced
    draw, name, notices = begin(paint, shown, size, budget)
    request = {
        "renderer": renderer,
        "paint": os.fspath(paint),
        "size": size,
        "turn": vars(turn),
        "budget": vars(budget),
    }
    key = hashlib.sha256(json.dumps([request, view_to_json(shown)], sort_keys=True).encode()).hexdigest()
    folder = path.absolute().parent / (path.name + ".part")
    done, exposure_ev = _begun(folder, key, fresh)
    if done:
        shown = replace(shown, exposure_mode="locked", exposure_ev=exposure_ev)
    tracing = subrange(progress, 0.05, 0.9 if video else 0.98)
    start = perf_counter()
    for number in range(done, turn.frames):
        spent, made = perf_counter() - start, number - done
        left = f", {spent / made * (turn.frames - number):.0f} s left" if made else ""
        report(tracing, number / turn.frames, f"frame {number + 1} of {turn.frames}{left}")
        step = (-360.0 if turn.clockwise else 360.0) / turn.frames
        codes, exposed = draw(turned(shown, number * step, bounds.centre))
        if number == 0:
            shown = replace(shown, exposure_mode="locked", exposure_ev=exposed.exposure_ev)
            with replacing(folder / _STATE) as temporary:
                temporary.write_text(json.dumps({"key": key, "exposure_ev": shown.exposure_ev}))
        write_png(_frame(folder, number), codes, {"Software": "BRDF Suite", "Title": name})
    if video:
        with writing_video(path, size, turn.frames_per_second, {"Title": name}) as feed:
            for number in range(turn.frames):
                report(progress, 0.9 + 0.1 * number / turn.frames, "writing the video")
                frame = read_rgb(_frame(folder, number), ("PNG",), most_bytes=most_made_bytes())
                feed(frame)
        shutil.rmtree(folder, ignore_errors=True)  # the video is there: what remains is no fault of it
    else:
        try:
            (folder / _STATE).unlink(missing_ok=True)
            if is_folder(path):
                path.rmdir()
            folder.rename(path)
            sync_folder(path.absolute().parent)
        except OSError as error:
            raise FileError(path, f"cannot be written: {error.strerror or error}") from error
    report(progress, 1.0, "written")
    return TurntableFiles(path, turn.frames, *size, name, notices)


def _reference(paint: str | os.PathLike[str], view: View, size: Size, budget: Budget) -> Started:
    from brdf_suite.tracing.reference.live import LiveReference

    live = LiveReference()
    live.show(paint, view, size)
    wanted = budget.samples or REFERENCE_SAMPLES

    def draw(view: View) -> tuple[Bytes, View]:
        live.show(paint, view, size)
        estimate = live.step()
        while estimate.samples < wanted:
            estimate = live.step()
        return live.codes(), live.scene.exposed_view(estimate)

    return draw, live.scene.name, live.scene.notices


def _raytraced(paint: str | os.PathLike[str], view: View, size: Size, budget: Budget) -> Started:
    from brdf_suite.tracing.raytraced.picture import RaytracedSession

    session = RaytracedSession()
    scene = session.show(paint, view, size, budget.quality, tables=budget.tables)

    def draw(view: View) -> tuple[Bytes, View]:
        session.show(paint, view, size, budget.quality, tables=budget.tables)
        *_, image = session.passes(samples=budget.samples)
        return image.codes(), image.exposed_view

    return draw, scene.name, scene.notices


def _begun(folder: Path, key: str, fresh: bool) -> tuple[int, float]:
    """Return how many frames are there from before, and their exposure; the folder is made, or emptied."""
    try:
        if is_folder(folder) and not fresh:
            state = json.loads(read_bytes(folder / _STATE))
            if state["key"] == key:
                done = 0
                while is_file(_frame(folder, done)):
                    done += 1
                return done, float(state["exposure_ev"])
    except (FileError, ValueError, KeyError, TypeError):
        pass  # a folder that was begun and holds no frame yet: it is begun anew
    try:
        if exists(folder):
            shutil.rmtree(folder)
    except OSError as error:
        raise FileError(folder, f"cannot be emptied: {error.strerror or error}") from error
    make_folder(folder)
    return 0, 0.0


def _frame(folder: Path, number: int) -> Path:
    return folder / f"frame_{number + 1:04d}.png"
