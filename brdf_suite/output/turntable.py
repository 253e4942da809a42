"""The turntable as a file: the object turns once before a camera and a light that stand still."""

from __future__ import annotations

import os
import secrets
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from brdf_suite.documents.atomic import check_folder_of, check_target, sync_folder
from brdf_suite.documents.view import View
from brdf_suite.errors import FileError, PathLike, ValueRangeError
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.output.exposures import exposures_of, focused
from brdf_suite.output.picture_file import PictureSettings, picture_metadata, write_picture
from brdf_suite.output.still import LoadedScene, loaded_scene
from brdf_suite.output.turning import turned
from brdf_suite.output.video import VIDEO_ENDINGS, check_video, ffmpeg, writing_video
from brdf_suite.pipeline.exposure import metered
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material, under_illuminant
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.realtime.camera import Bounds, resolve
from brdf_suite.regular_files import exists, is_folder

Size = tuple[int, int]
MOST_FRAMES = 7200
_FRAMING_STEPS = 24


@dataclass(frozen=True)
class Turn:
    """One turn: how many frames, how many a second in a video, and whether clockwise seen from above.

    ``shutter_deg`` says for how much of a frame's time the shutter is open, 360° for all of it.
    """

    frames: int = 120
    frames_per_second: float = 30.0
    clockwise: bool = False
    shutter_deg: float = 0.0

    def __post_init__(self) -> None:
        if not 2 <= self.frames <= MOST_FRAMES:
            raise ValueRangeError("frames", f"2 to {MOST_FRAMES} frames make a turn, not {self.frames}")
        if not 1.0 <= self.frames_per_second <= 240.0:
            raise ValueRangeError(
                "frames_per_second", f"1 to 240 are played a second, not {self.frames_per_second:g}"
            )
        if not 0.0 <= self.shutter_deg <= 360.0:
            raise ValueRangeError("shutter_deg", f"a shutter is open for 0 to 360°, not {self.shutter_deg:g}")

    @property
    def blur_deg(self) -> float:
        """By how much the object turns while the shutter is open, counter-clockwise seen from above."""
        return (-1.0 if self.clockwise else 1.0) * self.shutter_deg / self.frames


@dataclass(frozen=True)
class TurntableFiles:
    """What was written: a video, or a folder of PNG pictures."""

    path: Path
    frames: int
    width: int
    height: int
    paint: str
    notices: tuple[str, ...]


def framed_all_round(view: View, bounds: Bounds, size: Size) -> View:
    """Return the view with a camera that has the whole object in the picture from all sides, unless it is placed."""
    if view.camera.distance is not None:
        return replace(view, camera=resolve(view.camera, bounds, size))
    sides = [
        resolve(turned(view, 360.0 * step / _FRAMING_STEPS, bounds.centre).camera, bounds, size)
        for step in range(_FRAMING_STEPS)
    ]
    farthest = max(camera.distance for camera in sides if camera.distance is not None)
    return replace(view, camera=replace(sides[0], distance=farthest))


def write_turntable(
    paint: str | os.PathLike[str],
    view: View,
    size: Size,
    path: PathLike,
    turn: Turn | None = None,
    settings: PictureSettings | None = None,
    *,
    fitting: FitSettings | None = None,
    progress: Progress | None = None,
) -> TurntableFiles:
    """Draw one turn of a paint (by name or file) and write it: .mp4 or .webm, or a new folder of PNG pictures.

    ``fitting`` as for :func:`~brdf_suite.output.still.render_to_file`.

    Automatic exposure is measured once, for the first frame, so that the light does not pump. What was begun and not
    finished is taken away.

    Raises
    ------
    FileError
        As :func:`~brdf_suite.output.still.render_to_file`; the folder is there and not empty; ffmpeg failed.
    ExtraError
        There is no ffmpeg for a video.
    Cancelled
        The progress callback asked for it.
    """
    turn, settings, path = turn or Turn(), settings or PictureSettings(), Path(path)
    video = path.suffix.lower() in VIDEO_ENDINGS
    if video:
        check_target(path)
        if settings != replace(PictureSettings(), samples=settings.samples, exposures=settings.exposures):
            raise FileError(path, "a video has 8 bits in sRGB and no transparency; a folder of PNG has them")
        check_video(size)
        ffmpeg()
    else:
        check_folder(path)
        settings.of_file(path / "frame.png")
    fit = fit_material(under_illuminant(load_material(paint), view.light_colour), fitting)
    with loaded_scene(view, subrange(progress, 0.0, 0.2), fitting=fitting) as loaded:
        loaded.scene.set_material(fit)
        shown = framed_all_round(view, loaded.scene.renderer.bounds, size)
        shown = replace(metered(loaded.scene.renderer, shown, size), clipping_marks=False, gamut_marks=False)
        shown = replace(shown, lens=replace(shown.lens, turn_deg=turn.blur_deg))
        shown = focused(shown, loaded.mesh, size)
        metadata = picture_metadata(fit, shown)
        drawing = subrange(progress, 0.2, 1.0)
        if video:
            with writing_video(path, size, turn.frames_per_second, metadata) as feed:
                for frame in _frames(loaded, shown, turn, drawing):
                    blurred = exposures_of(frame, loaded.scene.renderer.bounds, size, settings.exposures)
                    strips = loaded.scene.renderer.strips(frame, size, settings.samples, exposures=blurred)
                    feed(np.concatenate(list(strips)))
        else:
            with _new_folder(path) as folder:
                for number, frame in enumerate(_frames(loaded, shown, turn, drawing), 1):
                    file = folder / f"frame_{number:04d}.png"
                    write_picture(loaded.scene.renderer, frame, size, file, settings, metadata)
    report(progress, 1.0, "written")
    notices = (*fit.notices, *loaded.prepared.environment.notes, *loaded.mesh.notes)
    return TurntableFiles(path, turn.frames, *size, fit.name, notices)


def _frames(loaded: LoadedScene, view: View, turn: Turn, progress: Progress | None) -> Iterator[View]:
    step = (-360.0 if turn.clockwise else 360.0) / turn.frames
    for number in range(turn.frames):
        report(progress, number / turn.frames, f"frame {number + 1} of {turn.frames}")
        yield turned(view, number * step, loaded.scene.renderer.bounds.centre)


def check_folder(path: Path) -> None:
    """Raise :class:`FileError` where ``path`` is no name of a folder, its own does not exist, or it is no empty one."""
    if path.suffix:
        raise FileError(
            path, "a turntable is an .mp4, a .webm, or a folder of PNG pictures: a name without ending"
        )
    check_folder_of(path)
    if (exists(path) or path.is_symlink()) and (not is_folder(path) or any(path.iterdir())):
        raise FileError(path, "is there already and not an empty folder; name a new one")


@contextmanager
def _new_folder(path: Path) -> Iterator[Path]:
    """Yield a folder that becomes ``path`` when the block ends well, and goes where it does not."""
    temporary = path.absolute().parent / f".{path.name[:80]}.{secrets.token_hex(8)}"
    try:
        temporary.mkdir()
    except OSError as error:
        raise FileError(path, f"cannot be made: {error.strerror or error}") from error
    try:
        yield temporary
        if is_folder(path):
            path.rmdir()
        temporary.rename(path)
        sync_folder(temporary.parent)
    except OSError as error:
        raise FileError(path, f"cannot be written: {error.strerror or error}") from error
    finally:
        if exists(temporary):
            shutil.rmtree(temporary, ignore_errors=True)  # the first error is the one to report
