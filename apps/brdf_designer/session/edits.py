"""The edits of a paint: each is a frozen value that gives a new paint, and has a name for Undo."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Literal

import numpy as np
from brdf_qt.program.translation import mark, tr

from brdf_designer.session.state import angle_text
from brdf_suite.appearance.clearcoat_gloss import HIGHEST_ROUGHNESS, LOWEST_ROUGHNESS
from brdf_suite.appearance.colour.spaces import lab_to_lch, lch_to_lab
from brdf_suite.appearance.flop.edits import (
    GREY_CHROMA,
    hue_difference,
    shift_labs,
    shift_lchs,
    with_flop_index,
    with_flop_travel,
)
from brdf_suite.appearance.geometries import GEOMETRY_SETS, Geometry
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import PARAMETERS, Flakes, Lab, OrangePeel, Paint, TextureTargets
from brdf_suite.errors import UnreachableError
from brdf_suite.paint_design.angle_sets import at_geometries, with_angle, without_angle
from brdf_suite.reflectance.designed.build import DarkerThanCoatError, gloss_of_coat

Space = Literal["lab", "lch"]
COMPONENTS = ("L*", "a*", "b*")
LCH_COMPONENTS = ("L*", "C*", "h")
DEFAULT_FLAKES = Flakes()
DEFAULT_PEEL = OrangePeel()
# Of L*a*b* that comes of angles: as fine as the numbers are shown, and a little more.
_DIGITS = 4
_GLOSS_DIGITS = 3
_HALVINGS = 14


class Edit(ABC):
    """A change of one field.

    ``is_dragged``: a field makes it that can be held while another document comes to the front. ``label``: what
    Undo calls it, where that does not depend on its values.
    """

    is_dragged: ClassVar[bool] = True
    label: ClassVar[str]

    @abstractmethod
    def apply(self, paint: Paint) -> Paint:
        """Return ``paint`` with the field set.

        Raises
        ------
        ValueRangeError
            The value is out of its range; the message names the field.
        UnreachableError
            No paint has the value.
        """

    def step(self, _paint: Paint, /) -> str:
        """Return what Undo calls the edit of a paint, as in ``Change L* at 15°``."""
        return tr(self.label)


@dataclass(frozen=True)
class SetLab(Edit):
    """Component 0 to 2 of L*a*b* at the measurement ``index``."""

    index: int
    component: int
    value: float

    def apply(self, paint: Paint) -> Paint:
        lab = list(paint.measurements[self.index].lab)
        lab[self.component] = float(self.value)
        return _with_lab(paint, self.index, (lab[0], lab[1], lab[2]))

    def step(self, paint: Paint, /) -> str:
        return _step_at(paint, self.index, COMPONENTS[self.component])


@dataclass(frozen=True)
class SetLch(Edit):
    """L*, C* or h (component 0 to 2; degrees) at the measurement ``index``; ``hue``, degrees, is what a grey has."""

    index: int
    component: int
    value: float
    hue: float

    def apply(self, paint: Paint) -> Paint:
        lch = lab_to_lch(paint.measurements[self.index].lab)
        if lch[1] < GREY_CHROMA:
            lch[2] = self.hue
        lch[self.component] = self.value
        return _with_lab(paint, self.index, _rounded(lch_to_lab(lch)))

    def step(self, paint: Paint, /) -> str:
        return _step_at(paint, self.index, LCH_COMPONENTS[self.component])


@dataclass(frozen=True)
class MoveAll(Edit):
    """Set a component at the measurement ``index``, in L*a*b* or LCh, and move it as far at all others."""

    space: Space
    index: int
    component: int
    value: float
    hue: float

    def apply(self, paint: Paint) -> Paint:
        labs = np.array([item.lab for item in paint.measurements])
        delta = np.zeros(3)
        if self.space == "lab":
            delta[self.component] = self.value - labs[self.index, self.component]
            moved = _with_labs(paint, shift_labs(labs, delta))
            # The colour that is edited gets the very number that was asked for.
            return SetLab(self.index, self.component, self.value).apply(moved)
        now = lab_to_lch(labs[self.index])
        if now[1] < GREY_CHROMA:
            now[2] = self.hue
        change = (
            hue_difference(now[2], self.value) if self.component == 2 else self.value - now[self.component]
        )
        delta[self.component] = change
        return _with_labs(paint, shift_lchs(labs, delta, self.hue))

    def step(self, _paint: Paint, /) -> str:
        names = COMPONENTS if self.space == "lab" else LCH_COMPONENTS
        return tr("Change {name} at All Angles").format(name=names[self.component])


def colour_edit(
    space: Space, index: int, component: int, value: float, hue: float, *, at_all_angles: bool
) -> Edit:
    """Return the edit of a component of a colour: :class:`SetLab`, :class:`SetLch` or :class:`MoveAll`."""
    if at_all_angles:
        return MoveAll(space, index, component, value, hue)
    if space == "lab" or component == 0:
        return SetLab(index, component, value)
    return SetLch(index, component, value, hue)


@dataclass(frozen=True)
class PickColour(Edit):
    """The whole colour at the measurement ``index``."""

    index: int
    lab: Lab

    def apply(self, paint: Paint) -> Paint:
        return _with_lab(paint, self.index, self.lab)

    def step(self, paint: Paint, /) -> str:
        return tr("Pick Colour at {angle}").format(angle=angle_text(paint, self.index))


@dataclass(frozen=True)
class MoveInPlane(Edit):
    """a* and b* at the measurement ``index``, L* kept; with ``at_all_angles`` the same difference at all others."""

    index: int
    a: float
    b: float
    at_all_angles: bool = False

    def apply(self, paint: Paint) -> Paint:
        lightness, a, b = paint.measurements[self.index].lab
        if self.at_all_angles:
            labs = np.array([item.lab for item in paint.measurements])
            paint = _with_labs(paint, shift_labs(labs, np.array([0.0, self.a - a, self.b - b])))
        return _with_lab(paint, self.index, (lightness, float(self.a), float(self.b)))

    def step(self, paint: Paint, /) -> str:
        if self.at_all_angles:
            return tr("Change Chroma and Hue at All Angles")
        return tr("Change Chroma and Hue at {angle}").format(angle=angle_text(paint, self.index))


@dataclass(frozen=True)
class TurnHues(Edit):
    """The hues of all measurements turned by ``degrees``, from red to yellow; L* and C* stay, and so do greys."""

    degrees: float
    label = mark("Turn Hue at All Angles")

    def apply(self, paint: Paint) -> Paint:
        lch = lab_to_lch([item.lab for item in paint.measurements])
        lch[:, 2] += self.degrees
        return _with_labs(paint, lch_to_lab(lch))


@dataclass(frozen=True)
class SetFlop(Edit):
    """The flop index, or the travel of ``lightness``, ``chroma`` or ``hue`` (degrees)."""

    what: str
    amount: float

    def apply(self, paint: Paint) -> Paint:
        angles = [item.aspecular_deg for item in paint.measurements]
        labs = np.array([item.lab for item in paint.measurements])
        return _with_labs(paint, moved_labs(angles, labs, self.what, self.amount))

    def step(self, _paint: Paint, /) -> str:
        return tr(_FLOP_STEPS[self.what])


def moved_labs(angles: list[float], labs: Floats, what: str, amount: float) -> Floats:
    """Return L*a*b* (n, 3) at ``angles``, degrees, with another flop: ``what`` and ``amount`` as :class:`SetFlop`."""
    if what == "index":
        return with_flop_index(angles, labs, amount)
    return with_flop_travel(angles, labs, ("lightness", "chroma", "hue").index(what), amount)


_FLOP_STEPS = {
    "index": mark("Change Flop Index"),
    "lightness": mark("Change Lightness Travel"),
    "chroma": mark("Change Chroma Travel"),
    "hue": mark("Change Hue Travel"),
}


@dataclass(frozen=True)
class SetNumber(Edit):
    """A number by its name in ``PARAMETERS``, as ``gloss.gu_20``; ``None`` where ``gloss.gu_60`` is not specified."""

    name: str
    value: float | None

    def apply(self, paint: Paint) -> Paint:
        part, _, field = self.name.rpartition(".")
        number: dict[str, Any] = {field: self.value}
        if part == "gloss":
            return replace(paint, gloss=replace(paint.gloss, **number))
        if part == "flakes":
            return replace(paint, flakes=replace(paint.flakes or DEFAULT_FLAKES, **number))
        if part == "orange_peel":
            return replace(paint, orange_peel=replace(paint.orange_peel or DEFAULT_PEEL, **number))
        return replace(paint, **number)

    def step(self, _paint: Paint, /) -> str:
        if self.name == "near_specular":
            return tr("Change Near-Specular Factor")
        return tr("Change {name}").format(name=PARAMETERS[self.name].label)


@dataclass(frozen=True)
class SetCoat(Edit):
    """The gloss that a coat of this index and roughness gives; ``what``, ``ior`` or ``roughness``, is what is moved."""

    what: str
    ior: float
    roughness: float

    def apply(self, paint: Paint) -> Paint:
        try:
            gloss = gloss_of_coat(paint, self.ior, self.roughness)
        except DarkerThanCoatError as error:
            raise self._too_rough(paint, error) from error
        assert gloss.gu_60 is not None
        gu_20, gu_60 = round(gloss.gu_20, _GLOSS_DIGITS), round(gloss.gu_60, _GLOSS_DIGITS)
        return replace(paint, gloss=replace(gloss, gu_20=gu_20, gu_60=gu_60))

    def step(self, _paint: Paint, /) -> str:
        return tr("Change Coat Index") if self.what == "ior" else tr("Change Coat Roughness")

    def _too_rough(self, paint: Paint, error: DarkerThanCoatError) -> TooRoughError:
        """Say why the coat cannot be, and how rough one of that index can be at most over these colours."""
        _, angle = error.measurement
        low, high = LOWEST_ROUGHNESS, HIGHEST_ROUGHNESS
        for _ in range(_HALVINGS):
            middle = math.sqrt(low * high)
            try:
                gloss_of_coat(paint, self.ior, middle)
            except DarkerThanCoatError:
                high = middle
            else:
                low = middle
        most = math.floor(1e4 * low) / 1e4
        text = tr(
            "With this roughness the coat alone reflects {share:.4f} of the light at "
            "{angle:g}°, more than the colour there. With index {ior:.3f} the roughness "
            "can be up to {most:.4f}."
        ).format(share=error.share, angle=angle, ior=self.ior, most=most)
        return TooRoughError(text, replace(self, roughness=most))


class TooRoughError(UnreachableError):
    """A coat too rough for the colours under it; ``nearest`` is the roughest that can be."""

    def __init__(self, text: str, nearest: SetCoat) -> None:
        super().__init__(text)
        self.nearest = nearest


@dataclass(frozen=True)
class SetField(Edit):
    """A whole field by its name in :class:`Paint`: a text, the interpolation, or a part (or None)."""

    field: Literal["name", "source", "notes", "interpolation", "flakes", "orange_peel", "texture"]
    value: str | Flakes | OrangePeel | TextureTargets | None
    is_dragged = False

    def apply(self, paint: Paint) -> Paint:
        change: dict[str, Any] = {self.field: self.value}
        return replace(paint, **change)

    def step(self, _paint: Paint, /) -> str:
        return tr(_FIELD_STEPS[self.field])


_FIELD_STEPS = {
    "name": mark("Rename Paint"),
    "source": mark("Edit Source"),
    "notes": mark("Edit Notes"),
    "interpolation": mark("Change Interpolation"),
    "flakes": mark("Flakes On"),
    "orange_peel": mark("Orange Peel On"),
    "texture": mark("Change Texture Targets"),
}


@dataclass(frozen=True)
class MakeSolid(Edit):
    """The colour at the measurement ``index`` at every angle."""

    index: int
    is_dragged = False
    label = mark("Make Solid")

    def apply(self, paint: Paint) -> Paint:
        lab = paint.measurements[self.index].lab
        return replace(paint, measurements=tuple(replace(item, lab=lab) for item in paint.measurements))


@dataclass(frozen=True)
class UseAngles(Edit):
    """The same paint at the angles of a set of :data:`GEOMETRY_SETS`."""

    name: str
    is_dragged = False
    label = mark("Change Angles")

    def apply(self, paint: Paint) -> Paint:
        return at_geometries(paint, GEOMETRY_SETS[self.name].geometries)


@dataclass(frozen=True)
class AddAngle(Edit):
    """A measurement at one more geometry, in the colour that the paint has there."""

    geometry: Geometry
    is_dragged = False
    label = mark("Add Angle")

    def apply(self, paint: Paint) -> Paint:
        return with_angle(paint, self.geometry)


@dataclass(frozen=True)
class RemoveAngle(Edit):
    """The paint without the measurement ``index``."""

    index: int
    is_dragged = False
    label = mark("Remove Angle")

    def apply(self, paint: Paint) -> Paint:
        return without_angle(paint, self.index)


def _step_at(paint: Paint, index: int, name: str) -> str:
    return tr("Change {name} at {angle}").format(name=name, angle=angle_text(paint, index))


def _with_lab(paint: Paint, index: int, lab: Lab) -> Paint:
    items = list(paint.measurements)
    items[index] = replace(items[index], lab=lab)
    return replace(paint, measurements=tuple(items))


def _with_labs(paint: Paint, labs: Floats) -> Paint:
    return replace(
        paint,
        measurements=tuple(
            item if tuple(row.tolist()) == item.lab else replace(item, lab=_rounded(row))
            for item, row in zip(paint.measurements, labs, strict=True)
        ),
    )


def _rounded(row: Floats) -> Lab:
    lightness, a, b = (round(float(value), _DIGITS) + 0.0 for value in row)
    return lightness, a, b
