"""The numbers of a reflectance that sliders change, and the reflectance with other values of them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any

import numpy as np

from brdf_suite.documents.parameter import Parameter
from brdf_suite.reflectance.guarded import GuardedReflectance
from brdf_suite.reflectance.live.model import LiveModel
from brdf_suite.reflectance.live.text import CHANNELS, ModelText
from brdf_suite.reflectance.protocol import DeclaredModel, Reflectance

_FIELD = re.compile(r"[A-Za-z_]\w*")


@dataclass(frozen=True)
class Adjustable:
    """A number of a reflectance: its declaration, its value, and whether it is a switch (0 or 1).

    ``channel`` is 0, 1 or 2 for a channel of a colour, whose three numbers follow each other; None for others.
    """

    parameter: Parameter
    value: float
    is_switch: bool = False
    channel: int | None = None


def adjustables(reflectance: Reflectance) -> dict[str, Adjustable]:
    """Return the numbers that can be changed, by key; none of measurements and of paints.

    A model's declared numbers and colours can; a colour ``f0`` as ``f0.r``, ``f0.g`` and ``f0.b``.
    """
    if isinstance(reflectance, LiveModel):
        return _of_text(reflectance.model, reflectance.values)
    inner = reflectance.inner if isinstance(reflectance, GuardedReflectance) else reflectance
    if not isinstance(inner, DeclaredModel) or not is_dataclass(inner):
        return {}
    found: dict[str, Adjustable] = {}
    names = {one.name for one in fields(inner) if one.init}
    for key, parameter in inner.parameters.items():
        if key not in names or not _FIELD.fullmatch(key):
            continue
        value = np.asarray(vars(inner)[key], np.float64)
        if value.shape == ():
            found[key] = Adjustable(parameter, float(value))
        elif value.shape == (3,):
            for channel, letter in enumerate(CHANNELS):
                found[f"{key}.{letter}"] = Adjustable(parameter, float(value[channel]), channel=channel)
    return found


def adjust(reflectance: Reflectance, values: Mapping[str, float]) -> Reflectance:
    """Return the reflectance with other values of some of its numbers, by the keys of :func:`adjustables`.

    Raises
    ------
    KeyError
        There is no such number.
    SuiteError
        A value is out of its range, or the model refuses it.
    """
    known = adjustables(reflectance)
    for key in values:
        known[key].parameter.check(float(values[key]), key)
    if isinstance(reflectance, LiveModel):
        return replace(reflectance, values={**reflectance.values, **values})
    inner = reflectance.inner if isinstance(reflectance, GuardedReflectance) else reflectance
    all_values = {key: values.get(key, one.value) for key, one in known.items()}
    changes: dict[str, Any] = {}
    for key, value in all_values.items():
        name, dot, _ = key.partition(".")
        changes[name] = tuple(all_values[f"{name}.{letter}"] for letter in CHANNELS) if dot else value
    if isinstance(reflectance, GuardedReflectance):
        with reflectance.plugin.blamed():
            return replace(reflectance, inner=replace(inner, **changes))  # type: ignore[type-var]
    changed: Reflectance = replace(inner, **changes)  # type: ignore[type-var]
    return changed


def _of_text(model: ModelText, values: Mapping[str, float]) -> dict[str, Adjustable]:
    found = {}
    for declared in model.declared:
        for channel, (key, parameter) in enumerate(declared.numbers().items()):
            is_colour = declared.kind == "color"
            found[key] = Adjustable(
                parameter, values[key], declared.kind == "bool", channel if is_colour else None
            )
    return found
