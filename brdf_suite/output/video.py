"""Frames to a video file, by an ffmpeg that runs as a process of its own: MP4 (H.264) or WebM (VP9)."""

from __future__ import annotations

import contextlib
import subprocess
import tempfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.atomic import replacing
from brdf_suite.errors import ExtraError, FileError, ValueRangeError
from brdf_suite.extras import import_extra

Size = tuple[int, int]

VIDEO_ENDINGS = (".mp4", ".webm")
_CODECS: dict[str, list[str]] = {
    ".mp4": ["-c:v", "libx264", "-preset", "medium", "-crf", "16", "-movflags", "+faststart", "-f", "mp4"],
    ".webm": ["-c:v", "libvpx-vp9", "-crf", "22", "-b:v", "0", "-row-mt", "1", "-f", "webm"],
}
# sRGB codes as they are, with the matrix of BT.709 and its primaries; the curve is said to be sRGB's.
_COLOUR = [
    *("-vf", "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p"),
    *[
        "-colorspace",
        "bt709",
        "-color_primaries",
        "bt709",
        "-color_trc",
        "iec61966-2-1",
        "-color_range",
        "tv",
    ],
]
_INSTEAD = "a turntable as a folder of PNG pictures needs nothing more"


def ffmpeg() -> str:
    """Return the ffmpeg program; :class:`ExtraError` where its package is missing or brings none."""
    package = import_extra("imageio_ffmpeg", purpose="a video", instead=_INSTEAD)
    try:
        return str(package.get_ffmpeg_exe())
    except RuntimeError as error:  # of another system's package, or with a wrong IMAGEIO_FFMPEG_EXE
        raise ExtraError(
            f"a video needs ffmpeg, which the installed imageio-ffmpeg does not contain and the system does not "
            f"offer; install the package ffmpeg with the package manager of this system, and {_INSTEAD}"
        ) from error


def check_video(size: Size) -> None:
    """Raise :class:`ValueRangeError` where no video has this size: colour is stored for blocks of 2 by 2 pixels."""
    if size[0] % 2 or size[1] % 2:
        even = tuple(edge + edge % 2 for edge in size)
        raise ValueRangeError(
            "size", f"a video has an even width and height: {even[0]}x{even[1]}, not {size[0]}x{size[1]}"
        )


@contextmanager
def writing_video(
    path: Path, size: Size, frames_per_second: float, metadata: Mapping[str, str]
) -> Iterator[Callable[[NDArray[Any]], None]]:
    """Yield a function that takes the next frame, (h, w, 3) uint8 sRGB, top row first.

    The file is there, whole, when the block ends well; where it does not, the old file stays.

    Raises
    ------
    ExtraError
        There is no ffmpeg.
    FileError
        It failed, with its last words.
    """
    program = ffmpeg()
    check_video(size)
    described = {"title": metadata.get("Title", ""), "comment": metadata.get("Description", "")}
    with replacing(path) as temporary, tempfile.TemporaryFile() as messages:
        command = [
            *(program, "-hide_banner", "-loglevel", "error", "-nostdin", "-y"),
            *("-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", f"{size[0]}x{size[1]}"),
            *("-framerate", f"{frames_per_second:g}", "-i", "pipe:0", "-an"),
            *_COLOUR,
            *_CODECS[path.suffix.lower()],
            *(part for name, text in described.items() for part in ("-metadata", f"{name}={text}")),
            str(temporary),
        ]
        with subprocess.Popen(  # noqa: S603 - ffmpeg of its package
            command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=messages
        ) as process:
            assert process.stdin is not None
            pipe = process.stdin

            def feed(frame: NDArray[Any]) -> None:
                if frame.shape != (size[1], size[0], 3) or frame.dtype != np.uint8:
                    wanted = f"({size[1]}, {size[0]}, 3) uint8"
                    raise ValueError(f"a frame must be {wanted}, not {frame.shape} {frame.dtype}")
                pipe.write(np.ascontiguousarray(frame).tobytes())
                pipe.flush()

            try:
                yield feed
                pipe.close()
                failed = process.wait() != 0
            except BrokenPipeError:
                failed = True
                _drop(pipe)
            except BaseException:
                process.kill()
                _drop(pipe)
                raise
        if failed:
            messages.seek(0)
            words = messages.read().decode(errors="replace").strip().splitlines()
            raise FileError(
                path, f"the video could not be made: {words[-1] if words else 'ffmpeg gave no reason'}"
            )


def _drop(pipe: IO[bytes]) -> None:
    """Close a pipe that has no reader any more; flushing the rest of a frame would raise again."""
    with contextlib.suppress(BrokenPipeError):
        pipe.close()
