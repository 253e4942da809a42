"""What is computed for a model: off the window's thread, without Qt."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from brdf_lobe_visualizer.model_text.starts import STARTS
from brdf_lobe_visualizer.subjects.sources import describe
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial
from brdf_suite.reflectance.adjusting import Adjustable, adjust, adjustables
from brdf_suite.reflectance.live.model import LiveModel
from brdf_suite.reflectance.live.text import ModelTextError, read_model_text, write_defaults
from brdf_suite.reflectance.material import Material
from brdf_suite.reflectance.protocol import Reflectance

__all__ = ["STARTS", "Change", "change", "line_of", "numbers_of", "open_text", "text_of", "text_with_values"]


@dataclass(frozen=True, eq=False)
class Change:
    """A material that changes: to a text where one is given, and to values of its numbers, by key."""

    material: Material
    text: str | None
    values: Mapping[str, float]


def change(asked: Change) -> PlottedMaterial:
    """Return what the change makes of the material, without key and line.

    Of the values of a text before those stay whose numbers are still declared and hold them.

    Raises
    ------
    SuiteError
        The text is no model or does not compile (:class:`ModelTextError`, with the line), or a value is refused.
    """
    if asked.text is None:
        reflectance = adjust(asked.material.reflectance, asked.values)
        if isinstance(reflectance, LiveModel):
            reflectance.try_out()
    else:
        live = LiveModel(read_model_text(asked.text))
        before = asked.material.reflectance
        old = {**before.values, **asked.values} if isinstance(before, LiveModel) else {}
        defaults = before.model.defaults if isinstance(before, LiveModel) else {}
        kept = {
            key: old[key]
            for key, one in adjustables(live).items()
            # A default that the text changes is what the user wants to see.
            if key in old
            and defaults.get(key) == one.parameter.default
            and one.parameter.low <= old[key] <= one.parameter.high
        }
        reflectance = live = replace(live, values=kept)
        live.try_out()
    if not isinstance(reflectance, LiveModel):
        return describe(replace(asked.material, reflectance=reflectance))
    return describe(
        replace(asked.material, reflectance=reflectance, facts=reflectance.facts, notices=reflectance.notes)
    )


def open_text(name: str, text: str) -> PlottedMaterial:
    """Return a new model of a text; errors as :func:`change`."""
    live = LiveModel.of(text)
    return describe(Material(name, live, notices=live.notes, facts=live.facts))


def numbers_of(material: Material | None) -> dict[str, Adjustable]:
    """Return what sliders change of a material: nothing of a paint and of measured data."""
    return {} if material is None or material.document is not None else adjustables(material.reflectance)


def text_of(reflectance: Reflectance) -> str | None:
    """Return the text of a model that has one."""
    return reflectance.model.text if isinstance(reflectance, LiveModel) else None


def text_with_values(reflectance: Reflectance) -> str:
    """Return the text of a model with its values as defaults; the empty text for what has none."""
    return write_defaults(reflectance.model, reflectance.values) if isinstance(reflectance, LiveModel) else ""


def line_of(error: Exception) -> int | None:
    """Return the line of a text that an error is about, from 1."""
    return error.line if isinstance(error, ModelTextError) else None
