"""Models written as text, GLSL as in ``.brdf`` files of the BRDF Explorer or Python's notation, read as a reflectance.

:mod:`brdf_suite.reflectance.live.text` describes both. A text computes values and can do nothing else.
"""

from __future__ import annotations

from brdf_suite.errors import FileError, GraphicsError, PathLike
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.reflectance.live.model import LiveModel
from brdf_suite.reflectance.live.text import LARGEST, ModelTextError, language_of
from brdf_suite.regular_files import read_bytes

_MOST_BYTES = 4 * LARGEST  # of UTF-8


def read_text(path: PathLike) -> str:
    """Return the text of a file; :class:`FileError` where it is too large or not UTF-8."""
    try:
        return read_bytes(path, _MOST_BYTES).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise FileError(path, "is no text in UTF-8", f"byte {error.start}") from error


def read_model(path: PathLike, _options: ReadOptions | None = None) -> LiveModel:
    """Return the model of a file with its default values; no option matters.

    Raises :class:`FileError`: it is no model or does not compile, with the line; there is no OpenGL for its GLSL; or it
    takes too long.
    """
    try:
        return LiveModel.of(read_text(path))
    except ModelTextError as error:
        raise FileError(path, error.reason, f"line {error.line}" if error.line else "its text") from error
    except GraphicsError as error:
        words = str(error).rstrip(".")
        raise FileError(path, words[:1].lower() + words[1:], "its shader") from error


FORMAT = MeasuredFormat(
    name="model_text",
    title="Model text (GLSL of the BRDF Explorer, or Python’s notation)",
    endings=(".brdf", ".py"),
    sniff=lambda head, _size: language_of(head.decode("utf-8", "replace")) is not None,
    read=read_model,
)
