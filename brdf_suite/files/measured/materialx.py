"""MaterialX documents (``.mtlx``): Standard Surface, OpenPBR Surface and glTF PBR, read as reflectances.

A document is XML whose root is ``materialx``. A surface shader is an element ``standard_surface``,
``open_pbr_surface`` or ``gltf_pbr`` with ``input`` children (documents before 1.38 say ``parameter``, or
``shaderref`` with ``bindinput``), and a ``surfacematerial`` names it. Read is the shader of the first material, or
the first shader.

An input that is connected to a constant, also through the interface of a node graph, has that value. Textures and
computed inputs are not read: the input keeps its default, and a notice names it, as it names everything else of a
shader that a reflectance at one place cannot hold. Colours are brought to linear Rec. 709 from the colour space that
their input, an element around it, or the document names. The defaults are those of MaterialX 1.39's definitions.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace

import numpy as np

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB, rgb_to_working, srgb_decode
from brdf_suite.appearance.colour.spaces import P3_PRIMARIES
from brdf_suite.arrays import Floats
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.hardened_xml import Element, parse_xml
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.files.measured.goniometer_rows import one_line
from brdf_suite.reflectance.renderers.facet_lobe import index_of, normal_reflectance
from brdf_suite.reflectance.renderers.surface_shader import BLACK, WHITE, Rgb, SurfaceShader
from brdf_suite.regular_files import read_bytes

_LARGEST = 64 << 20
_DEEPEST = 16
_LEAST_ALPHA, _LARGEST_INDEX = 1e-3, 50.0
_D65, _ACES = (0.3127, 0.3290), (0.32168, 0.33767)
_ADOBE = ((0.64, 0.33), (0.21, 0.71), (0.15, 0.06))
_AP1 = ((0.713, 0.293), (0.165, 0.830), (0.128, 0.044))
_REC2020 = ((0.708, 0.292), (0.170, 0.797), (0.131, 0.046))


def _power(exponent: float) -> Callable[[Floats], Floats]:
    return lambda encoded: np.asarray(np.maximum(encoded, 0.0) ** exponent)


def _linear(values: Floats) -> Floats:
    return values


def _matrix(primaries: tuple[tuple[float, float], ...], white: tuple[float, float]) -> Floats:
    return np.asarray(WORKING_TO_SRGB @ rgb_to_working(primaries, white))


_SAME: Floats = np.eye(3)
_SPACES: dict[str, tuple[Callable[[Floats], Floats], Floats]] = {
    "": (_linear, _SAME),
    "none": (_linear, _SAME),
    "lin_rec709": (_linear, _SAME),
    "lin_srgb": (_linear, _SAME),
    "srgb_texture": (srgb_decode, _SAME),
    "srgb_displayp3": (srgb_decode, _matrix(P3_PRIMARIES, _D65)),
    "lin_displayp3": (_linear, _matrix(P3_PRIMARIES, _D65)),
    "g18_rec709": (_power(1.8), _SAME),
    "g22_rec709": (_power(2.2), _SAME),
    "rec709_display": (_power(2.4), _SAME),
    "adobergb": (_power(563 / 256), _matrix(_ADOBE, _D65)),
    "lin_adobergb": (_linear, _matrix(_ADOBE, _D65)),
    "acescg": (_linear, _matrix(_AP1, _ACES)),
    "lin_ap1": (_linear, _matrix(_AP1, _ACES)),
    "g22_ap1": (_power(2.2), _matrix(_AP1, _ACES)),
    "lin_rec2020": (_linear, _matrix(_REC2020, _D65)),
}
"""By the names of MaterialX: the curve, and the matrix to linear Rec. 709."""

_Value = float | Rgb | bool

_DEFAULTS: dict[str, dict[str, _Value]] = {
    "standard_surface": {
        "base": 1.0, "base_color": (0.8, 0.8, 0.8), "diffuse_roughness": 0.0, "metalness": 0.0, "specular": 1.0,
        "specular_color": WHITE, "specular_roughness": 0.2, "specular_IOR": 1.5, "subsurface": 0.0,
        "subsurface_color": WHITE, "coat": 0.0, "coat_color": WHITE, "coat_roughness": 0.1, "coat_IOR": 1.5,
        "coat_affect_color": 0.0, "coat_affect_roughness": 0.0, "transmission": 0.0,
    },
    "open_pbr_surface": {
        "base_weight": 1.0, "base_color": (0.8, 0.8, 0.8), "base_diffuse_roughness": 0.0, "base_metalness": 0.0,
        "specular_weight": 1.0, "specular_color": WHITE, "specular_roughness": 0.3, "specular_ior": 1.5,
        "subsurface_weight": 0.0, "subsurface_color": (0.8, 0.8, 0.8), "coat_weight": 0.0, "coat_color": WHITE,
        "coat_roughness": 0.0, "coat_ior": 1.6, "coat_darkening": 1.0, "transmission_weight": 0.0,
    },
    "gltf_pbr": {
        "base_color": WHITE, "metallic": 1.0, "roughness": 1.0, "specular": 1.0, "specular_color": WHITE, "ior": 1.5,
        "clearcoat": 0.0, "clearcoat_roughness": 0.0, "transmission": 0.0,
    },
}  # fmt: skip
"""What is read, and the default."""

_LEFT_OUT: dict[str, dict[str, _Value]] = {
    "standard_surface": {
        "specular_anisotropy": 0.0, "coat_anisotropy": 0.0, "sheen": 0.0, "thin_film_thickness": 0.0, "emission": 0.0,
        "opacity": WHITE, "thin_walled": False,
    },
    "open_pbr_surface": {
        "specular_roughness_anisotropy": 0.0, "coat_roughness_anisotropy": 0.0, "fuzz_weight": 0.0,
        "thin_film_weight": 0.0, "emission_luminance": 0.0, "geometry_opacity": 1.0, "geometry_thin_walled": False,
    },
    "gltf_pbr": {
        "anisotropy_strength": 0.0, "sheen_color": BLACK, "iridescence": 0.0, "emissive": BLACK, "alpha_mode": 0.0,
    },
}  # fmt: skip
"""What a reflectance at one place does not hold, and the value at which nothing is lost."""

_GEOMETRY = ("normal", "tangent")
_TITLES = {
    "standard_surface": "Standard Surface",
    "open_pbr_surface": "OpenPBR Surface",
    "gltf_pbr": "glTF PBR",
}
_BEYOND = ("transmission", "transmission_weight")
_PASSED = ("dot", "convert")
_OLD = ("1.0.0", (1.36, 1.37))
"""The definition of Standard Surface that documents of these versions mean: the base is 0.8 of white."""


def read_materialx(path: PathLike, _options: ReadOptions | None = None) -> SurfaceShader:
    """Return the shader of a document; raise :class:`FileError` with the line of the first fault.

    No option matters: parameters are colours, not spectra.
    """
    root = parse_xml(read_bytes(path, _LARGEST), path)
    if root.name != "materialx":
        raise FileError(path, f"expected the root materialx, not {root.name[:40]!r}", f"line {root.line}")
    document = _Document(path, root)
    shader, name, others = document.find_shader()
    inputs = _Inputs(document, shader)
    made = _MAKERS[inputs.model](inputs)
    inputs.note_left_out()
    facts: dict[str, object] = {
        "format": "MaterialX",
        "name": one_line(name),
        "model": _TITLES[inputs.model],
        "version": one_line(root.attributes.get("version", "")),
    }
    notes = inputs.notes()
    if others:
        named = ", ".join(others[:5]) + (" …" if len(others) > 5 else "")
        notes.append(
            f"The document holds {len(others) + 1} materials; “{one_line(name)}” was read, not {named}."
        )
    if notes:
        facts["notes"] = tuple(notes)
    return replace(made, source=os.fspath(path), facts=facts)


class _Document:
    """Elements by their names, and their parents."""

    def __init__(self, path: PathLike, root: Element) -> None:
        self.path, self.root = path, root
        self.parents: dict[int, Element] = {}
        self._names: dict[int, dict[str, Element]] = {}
        self.elements = list(root.walk())
        for element in self.elements:
            for child in element.children:
                self.parents[id(child)] = element
        self.version = self._version()

    def _version(self) -> float:
        major, _, minor = self.root.attributes.get("version", "").partition(".")
        try:
            return float(f"{int(major)}.{int(minor or 0):02d}")
        except ValueError as error:
            shown = self.root.attributes.get("version", "")[:20]
            reason = f"the version {shown!r} is none of MaterialX"
            raise FileError(self.path, reason, f"line {self.root.line}") from error

    def find_shader(self) -> tuple[Element, str, list[str]]:
        """Return the shader, its material's name, and the names of the other materials."""
        found: dict[str, Element] = {}
        for element in self.elements:
            name = element.attributes.get("name", "")
            if element.name == "surfacematerial":
                source = next(
                    (i for i in element.children if i.attributes.get("name") == "surfaceshader"), None
                )
                target = None if source is None else self.connected(source)
                if target is not None and target.name in _MAKERS:
                    found[name] = target
            elif element.name == "material":
                for reference in element.all("shaderref"):
                    if reference.attributes.get("node") in _MAKERS:
                        found[name] = reference
        if not found:
            found = {e.attributes.get("name", ""): e for e in self.elements if e.name in _MAKERS}
        if not found:
            kinds = {e.name for e in self.elements if e.attributes.get("type") == "surfaceshader"} - {"input"}
            shown = ", ".join(sorted(kinds))[:80] or "none"
            known = ", ".join(_TITLES.values())
            reason = f"holds no surface shader that is known ({known}); found: {shown}"
            raise FileError(self.path, reason, f"line {self.root.line}")
        (name, shader), *others = found.items()
        return shader, name, [one_line(other) or "(no name)" for other, _ in others]

    def named(self, name: str, within: Element) -> Element | None:
        """Return the node of that name among the children of an element, or None."""
        if id(within) not in self._names:
            nodes = (child for child in reversed(within.children) if child.name != "input")
            self._names[id(within)] = {node.attributes.get("name", ""): node for node in nodes}
        return self._names[id(within)].get(name)

    def connected(self, place: Element) -> Element | None:
        """Return the element that an input or output is connected to, or None."""
        scope: Element | None = self.parents.get(id(place))
        graph = place.attributes.get("nodegraph")
        if graph is not None:
            holder = self.named(graph, self.root)
            if holder is None:
                return None
            wanted = place.attributes.get("output") or "out"
            outputs = holder.all("output")
            chosen = next((o for o in outputs if o.attributes.get("name") == wanted), None)
            return chosen or (outputs[0] if len(outputs) == 1 else None)
        name = place.attributes.get("nodename")
        while name is not None and scope is not None:
            found = self.named(name, scope)
            if found is not None:
                return found
            scope = self.parents.get(id(scope))
        return None

    def space(self, element: Element) -> str:
        """Return the colour space that holds at an element."""
        place: Element | None = element
        while place is not None:
            if "colorspace" in place.attributes:
                return place.attributes["colorspace"].lower()
            place = self.parents.get(id(place))
        return ""


@dataclass
class _Inputs:
    """The inputs of a shader, with notices about what is not read."""

    document: _Document
    shader: Element
    unread: list[str] = field(default_factory=list)
    limited: list[str] = field(default_factory=list)
    lost: list[str] = field(default_factory=list)
    said: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.model = self.shader.attributes.get("node", self.shader.name)
        self._given = {
            child.attributes.get("name", ""): child
            for child in self.shader.children
            if child.name in ("input", "parameter", "bindinput")
        }
        self._defaults = dict(_DEFAULTS[self.model])
        old = self.shader.attributes.get("version") == _OLD[0]
        if self.model == "standard_surface" and (old or self.document.version in _OLD[1]):
            self._defaults |= {"base": 0.8, "base_color": WHITE}

    def fail(self, reason: str, element: Element) -> FileError:
        return FileError(self.document.path, reason, f"line {element.line}")

    def number(self, name: str, low: float = 0.0, high: float = 1.0) -> float:
        """Return a float, limited."""
        given = self._value(name, self._defaults[name])
        value = float(given) if not isinstance(given, tuple) else float(np.mean(given))
        held = min(max(value, low), high)
        if held != value:
            self.limited.append(f"{name} {value:.4g} → {held:g}")
        return held

    def colour(self, name: str) -> Rgb:
        """Return a colour, 0 to 1."""
        given = self._value(name, self._defaults[name])
        value = given if isinstance(given, tuple) else (float(given),) * 3
        red, green, blue = (min(max(channel, 0.0), 1.0) for channel in value)
        if (red, green, blue) != value:
            self.limited.append(f"{name} → 0…1")
        return red, green, blue

    def index(self, name: str) -> float:
        """Return an index of refraction, at least 1."""
        value = self.number(name, 0.0, _LARGEST_INDEX)
        if value <= 0.0:
            value = 1.0
        if value < 1.0:
            self.limited.append(f"{name} {value:.4g} → {1.0 / value:.4g}")
            value = 1.0 / value
        return value

    def alpha(self, roughness: float, name: str) -> float:
        """Return the width of a lobe; one below the least is a mirror, of which there is no table."""
        alpha = roughness * roughness
        if alpha < _LEAST_ALPHA:
            self.limited.append(f"{name} {roughness:.4g} → {math.sqrt(_LEAST_ALPHA):.3g}")
        return max(alpha, _LEAST_ALPHA)

    def _value(self, name: str, default: _Value) -> _Value:
        place = self._given.get(name)
        if place is None:
            return default
        found, why = self._resolve(place, 0)
        if found is not None:
            return found
        if why:
            self.unread.append(f"{name} ({why})")
        return default

    def _resolve(self, place: Element, depth: int) -> tuple[_Value | None, str]:
        """Return the value of an input, or None and what stands there instead."""
        if depth > _DEEPEST:
            raise self.fail("the connections of an input go round, or are too deep", place)
        attributes = place.attributes
        if "interfacename" in attributes:
            return self._interface(place, depth)
        if "nodename" in attributes or "nodegraph" in attributes:
            target = self.document.connected(place)
            if target is None:
                return None, "a connection to nothing"
            if target.name == "output":
                return self._resolve(target, depth + 1)
            if target.name == "constant" or target.name in _PASSED:
                wanted = "value" if target.name == "constant" else "in"
                inner = next((c for c in target.children if c.attributes.get("name") == wanted), None)
                return self._resolve(inner, depth + 1) if inner is not None else (None, target.name)
            return None, one_line(target.name)[:40]
        if "value" in attributes:
            return self._parse(place, attributes["value"]), ""
        return None, ""

    def _interface(self, place: Element, depth: int) -> tuple[_Value | None, str]:
        scope = self.document.parents.get(id(place))
        while scope is not None and scope.name != "nodegraph":
            scope = self.document.parents.get(id(scope))
        wanted = place.attributes["interfacename"]
        inputs = [] if scope is None else [*scope.all("input"), *scope.all("parameter")]
        inner = next((i for i in inputs if i.attributes.get("name") == wanted), None)
        return (
            self._resolve(inner, depth + 1) if inner is not None else (None, "an interface without a value")
        )

    def _parse(self, place: Element, text: str) -> _Value:
        kind = place.attributes.get("type", "float")
        if kind == "boolean":
            return text.strip().lower() == "true"
        words = text.replace(",", " ").split()
        numbers = []
        for word in words:
            try:
                numbers.append(math.nan if "_" in word else float(word))
            except ValueError:
                numbers.append(math.nan)
        count = {"color3": 3, "color4": 4, "vector3": 3, "vector2": 2}.get(kind, 1)
        if len(numbers) != count or not all(
            math.isfinite(number) and abs(number) < 1e9 for number in numbers
        ):
            name = one_line(place.attributes.get("name", ""))[:40]
            raise self.fail(f"{name!r} is {text[:40]!r}; expected {count} finite numbers", place)
        if kind in ("color3", "color4"):
            return self._to_709(place, np.array(numbers[:3]))
        return numbers[0] if count == 1 else (numbers[0], numbers[1], numbers[-1])

    def _to_709(self, place: Element, colour: Floats) -> Rgb:
        name = self.document.space(place)
        if name not in _SPACES:
            note = f"The colour space “{one_line(name)[:40]}” is not known; its colours were taken as linear Rec. 709."
            if note not in self.said:
                self.said.append(note)
            name = ""
        curve, matrix = _SPACES[name]
        # What rounding leaves of a white's adaptation is no loss.
        red, green, blue = np.round(matrix @ curve(colour), 12).tolist()
        return red, green, blue

    def note_left_out(self) -> None:
        """Note the inputs that nothing stands for here."""
        neutral = _LEFT_OUT[self.model]
        for name, place in self._given.items():
            if name in neutral:
                found, why = self._resolve(place, 0)
                if why or (found is not None and found != neutral[name]):
                    self.lost.append(f"{name} ({why or _shown(found)})")
            elif any(word in name for word in _GEOMETRY) and {"nodename", "nodegraph"} & set(
                place.attributes
            ):
                self.lost.append(f"{name} (given by a map)")
        for name in _BEYOND:
            if name in self._defaults and (share := self.number(name)) > 0.0:
                self.lost.append(f"{name} ({share:g})")

    def notes(self) -> list[str]:
        """Return the notices, each a sentence."""
        found = list(self.said)
        if self.unread:
            found.append(
                f"Textures and computed inputs are not read; defaults stand for {_listed(self.unread)}."
            )
        if self.lost:
            found.append(f"Left out: {_listed(self.lost)}.")
        if self.limited:
            found.append(f"Values limited: {_listed(self.limited)}.")
        return found


def _listed(names: Iterable[str]) -> str:
    return "; ".join(dict.fromkeys(names))


def _shown(value: _Value | None) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)


def _mixed(share: float, colour: Rgb) -> Floats:
    """Return white, and ``share`` of the colour instead."""
    return 1.0 - share + share * np.asarray(colour)


def _rgb(values: Floats) -> Rgb:
    red, green, blue = values.tolist()
    return red, green, blue


def _standard(inputs: _Inputs) -> SurfaceShader:
    coat, coat_roughness = inputs.number("coat"), inputs.number("coat_roughness")
    rough = inputs.number("specular_roughness")
    share = inputs.number("coat_affect_roughness") * coat * coat_roughness
    rough += share * (1.0 - rough)
    gamma = 1.0 + coat * inputs.number("coat_affect_color")
    below = inputs.number("subsurface")
    passed = 1.0 - inputs.number("transmission")
    base, colour = inputs.number("base"), np.asarray(inputs.colour("base_color"))
    index, specular = inputs.index("specular_IOR"), inputs.number("specular")
    f0 = normal_reflectance(index)
    return SurfaceShader(
        base=_rgb(passed * (1.0 - below) * base * colour**gamma),
        base_roughness=inputs.number("diffuse_roughness"),
        subsurface=_rgb(passed * below * np.asarray(inputs.colour("subsurface_color")) ** gamma),
        specular=specular if index > 1.0 else 0.0,
        specular_f0=(f0, f0, f0),
        specular_ior=index,
        tint=inputs.colour("specular_color"),
        alpha=inputs.alpha(rough, "specular_roughness"),
        metalness=inputs.number("metalness"),
        metal_f0=_rgb(base * colour),
        metal_edge=_rgb(specular * np.asarray(inputs.colour("specular_color"))),
        conductor=True,
        attenuation=_rgb(_mixed(coat, inputs.colour("coat_color"))),
        coat=coat,
        coat_ior=inputs.index("coat_IOR"),
        coat_alpha=inputs.alpha(coat_roughness, "coat_roughness") if coat > 0.0 else _LEAST_ALPHA,
    )


def _openpbr(inputs: _Inputs) -> SurfaceShader:
    coat, coat_roughness = inputs.number("coat_weight"), inputs.number("coat_roughness")
    rough = inputs.number("specular_roughness")
    rough += coat * (min(1.0, rough**4 + 2.0 * coat_roughness**4) ** 0.25 - rough)
    below, weight = inputs.number("subsurface_weight"), inputs.number("specular_weight", 0.0, 1e3)
    passed = 1.0 - inputs.number("transmission_weight")
    base, colour = inputs.number("base_weight"), np.asarray(inputs.colour("base_color"))
    under = np.asarray(inputs.colour("subsurface_color"))
    index, coat_index = inputs.index("specular_ior"), inputs.index("coat_ior")
    inside = max(index / coat_index, coat_index / index)
    f0 = min(weight * normal_reflectance(index + coat * (inside - index)), 0.99999)
    metalness = inputs.number("base_metalness")
    # What the coat sends back to the base is reflected again, and darkens it.
    back = 1.0 - (1.0 - normal_reflectance(coat_index)) / coat_index**2
    albedo = metalness * colour * weight + (1.0 - metalness) * ((1.0 - below) * colour + below * under)
    dark = (1.0 - back) / (1.0 - np.clip(albedo, 0.0, 1.0) * back)
    darkening = 1.0 + coat * inputs.number("coat_darkening") * (dark - 1.0)
    return SurfaceShader(
        base=_rgb(passed * (1.0 - below) * base * colour),
        base_roughness=inputs.number("base_diffuse_roughness"),
        compensated=True,
        subsurface=_rgb(passed * below * under),
        specular=1.0 if f0 > 0.0 else 0.0,
        specular_f0=(f0, f0, f0),
        specular_ior=index_of(f0),
        tint=inputs.colour("specular_color"),
        alpha=inputs.alpha(rough, "specular_roughness"),
        metalness=metalness,
        metal=weight,
        metal_f0=_rgb(base * colour),
        metal_edge=inputs.colour("specular_color"),
        attenuation=_rgb(darkening * _mixed(coat, inputs.colour("coat_color"))),
        coat=coat,
        coat_ior=coat_index,
        coat_alpha=inputs.alpha(coat_roughness, "coat_roughness") if coat > 0.0 else _LEAST_ALPHA,
    )


def _gltf(inputs: _Inputs) -> SurfaceShader:
    specular, coat = inputs.number("specular"), inputs.number("clearcoat")
    colour = np.asarray(inputs.colour("base_color"))
    f0 = np.minimum(
        normal_reflectance(inputs.index("ior")) * np.asarray(inputs.colour("specular_color")), 1.0
    )
    return SurfaceShader(
        base=_rgb((1.0 - inputs.number("transmission")) * colour),
        specular=1.0 if specular > 0.0 else 0.0,
        specular_f0=_rgb(specular * f0),
        specular_f90=(specular, specular, specular),
        alpha=inputs.alpha(inputs.number("roughness"), "roughness"),
        metalness=inputs.number("metallic"),
        metal_f0=_rgb(colour),
        attenuation=WHITE,
        coat=coat,
        coat_ior=1.5,
        coat_alpha=inputs.alpha(inputs.number("clearcoat_roughness"), "clearcoat_roughness")
        if coat > 0.0
        else _LEAST_ALPHA,
    )


_MAKERS: dict[str, Callable[[_Inputs], SurfaceShader]] = {
    "standard_surface": _standard,
    "open_pbr_surface": _openpbr,
    "gltf_pbr": _gltf,
}


FORMAT = MeasuredFormat(
    name="materialx",
    title="MaterialX surface shader",
    endings=(".mtlx",),
    sniff=lambda head, _size: b"<materialx" in head[:20_000],
    read=read_materialx,
)
