"""Texture reads and instructions of the default frame, counted in what Mesa's compiler makes of its shaders.

Both sides of every condition count. The counts are compared with a graphics card's published limits; `gpu` times frames
on a card.
"""

from __future__ import annotations

from pathlib import Path

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress

_counts = load_module(Path(__file__).parent / "parts" / "shader_counts.py")

NAME = "shader"
_RATE = 3840 * 2160 * 120.0
"""Pixels a second that the default frame is designed for."""
_CARD = "GeForce RTX 4070"
_CORES, _TEXTURE_UNITS, _CLOCK, _BANDWIDTH = 5888, 184, 2.475e9, 504.2e9
"""An instruction of each core and a filtered texel of each unit a clock; bytes a second. As listed on
www.thefpsreview.com/gpu-family/nvidia-geforce-rtx-4070-gpu-family-specifications."""
_SAMPLE_BYTES, _SCREEN_BYTES = 8 + 4 + 4, 4 * 8 + 4 * 8 + 4 * 4 + 4
"""Of each sample that is drawn: its half floats, and its depth read and written. Of each pixel: its four samples read
for glare and for the screen, their depth cleared, and what is shown."""

BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "frame_reads": ("", None, "", "texture reads a pixel of the default frame, mean of all its pixels"),
    "frame_instructions": ("", None, "", "instructions a pixel, likewise; slow ones by what they take"),
    "paint_reads": ("", None, "", "texture reads of a pixel of the paint, flakes glinting in one light"),
    "paint_instructions": ("", None, "", "instructions of such a pixel"),
    "reads_share": (
        "<=",
        0.5,
        "",
        f"of the texels that a {_CARD} can filter, 3840x2160 at 120 frames a second",
    ),
    "instructions_share": ("<=", 0.5, "", "of the instructions that it can carry out"),
    "bytes_share": ("<=", 0.5, "", "of what its memory can move, the samples not compressed"),
}
NOTES: dict[str, str] = {}


def run(_progress: Progress | None = None) -> dict[str, float | None]:
    """Return the figures of :data:`BOUNDS`: all None where the driver does not say, which NOTES then say."""
    try:
        frame, paint, samples = _counts.counts()
    except SuiteError as error:
        NOTES.update(dict.fromkeys(BOUNDS, f"not counted: {error}"))
        return dict.fromkeys(BOUNDS)
    filtered = frame.filtered * _counts.FILTERED + frame.plain
    return {
        "frame_reads": frame.reads,
        "frame_instructions": frame.instructions,
        "paint_reads": paint.reads,
        "paint_instructions": paint.instructions,
        "reads_share": filtered * _RATE / (_TEXTURE_UNITS * _CLOCK),
        "instructions_share": frame.instructions * _RATE / (_CORES * _CLOCK),
        "bytes_share": (samples * _SAMPLE_BYTES + _SCREEN_BYTES) * _RATE / _BANDWIDTH,
    }
