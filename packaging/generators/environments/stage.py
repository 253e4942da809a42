"""What a scene is made of: materials, meshes and luminous panels, as Mitsuba has them.

Radiance is in kcd/m² and linear Rec. 2020 throughout: Mitsuba's three channels are taken as such, so that colours pass
unconverted.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from brdf_suite.arrays import Floats
from brdf_suite.reference.mitsuba_modules import mi
from environments.solids import Solid, join


def colour_of(value: ArrayLike) -> dict[str, Any]:
    """Return one colour (3,) as Mitsuba has it."""
    return {"type": "rgb", "value": [float(v) for v in np.asarray(value)]}


def picture(pixels: Floats, wide: float = 1.0, high: float = 1.0) -> dict[str, Any]:
    """Return a bitmap (h, w, 3) that repeats after ``wide`` by ``high`` metres of uv, its row 0 on top."""
    bitmap = mi.Bitmap(np.ascontiguousarray(pixels[::-1], dtype=np.float32))
    scale = mi.ScalarTransform4f().scale([1.0 / wide, 1.0 / high, 1.0])
    return {"type": "bitmap", "bitmap": bitmap, "raw": True, "to_uv": scale, "wrap_mode": "repeat"}


FACE_COLOUR: dict[str, Any] = {"type": "palette"}
"""Stands for the colours of the faces themselves; they become a bitmap with one pixel for each."""


def matt(reflectance: Mapping[str, Any] = FACE_COLOUR) -> dict[str, Any]:
    """Return a matt surface, the same from both sides."""
    return {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": dict(reflectance)}}


def glazed(reflectance: Mapping[str, Any] = FACE_COLOUR, roughness: float = 0.0) -> dict[str, Any]:
    """Return a body colour below a clear coat, polished or of a GGX roughness."""
    kind: dict[str, Any] = {"type": "roughplastic", "distribution": "ggx", "alpha": roughness}
    made = kind if roughness > 0.0 else {"type": "plastic"}
    return {"type": "twosided", "bsdf": made | {"diffuse_reflectance": dict(reflectance), "nonlinear": True}}


def metal(reflectance: ArrayLike, roughness: float) -> dict[str, Any]:
    """Return brushed or painted metal of one colour."""
    base = {"type": "roughconductor", "material": "none", "distribution": "ggx", "alpha": roughness}
    return {"type": "twosided", "bsdf": base | {"specular_reflectance": colour_of(reflectance)}}


def mesh(
    solid: Solid, material: Mapping[str, Any], radiance: Mapping[str, Any] | None = None, power: float = 1.0
) -> Any:
    """Return a mesh of Mitsuba; a palette in its material is that of its faces."""
    normals = _normals(solid) if solid.smooth else None
    points, faces, uv = solid.points, solid.faces, solid.uv
    if _has_palette(material):
        colours, which = np.unique(np.round(solid.colours, 4), axis=0, return_inverse=True)
        palette = {
            "type": "bitmap",
            "bitmap": mi.Bitmap(np.ascontiguousarray(colours[None], dtype=np.float32)),
            "raw": True,
            "filter_type": "nearest",
            "wrap_mode": "clamp",
        }
        material = _with_palette(material, palette)
        # Each face has corners of its own, which lie in its pixel.
        normals = None if normals is None else normals[faces].reshape(-1, 3)
        points, faces = points[faces].reshape(-1, 3), np.arange(faces.size).reshape(-1, 3)
        middle = (which.reshape(-1) + 0.5) / len(colours)
        uv = np.stack([np.repeat(middle, 3), np.full(faces.size, 0.5)], axis=-1)
    properties = mi.Properties()
    properties["mesh_bsdf"] = mi.load_dict(dict(material))
    if radiance is not None:
        properties["mesh_emitter"] = mi.load_dict(
            {"type": "area", "radiance": dict(radiance), "sampling_weight": power}
        )
    made = mi.Mesh(
        "solid",
        len(points),
        len(faces),
        props=properties,
        has_vertex_texcoords=True,
        has_vertex_normals=normals is not None,
    )
    values = mi.traverse(made)
    values["vertex_positions"] = points.astype(np.float32).ravel()
    values["faces"] = faces.astype(np.uint32).ravel()
    values["vertex_texcoords"] = uv.astype(np.float32).ravel()
    if normals is not None:
        values["vertex_normals"] = normals.astype(np.float32).ravel()
    values.update()
    return made


def _has_palette(description: Mapping[str, Any]) -> bool:
    return description == FACE_COLOUR or any(
        _has_palette(v) for v in description.values() if isinstance(v, dict)
    )


def _with_palette(description: Mapping[str, Any], palette: dict[str, Any]) -> dict[str, Any]:
    if description == FACE_COLOUR:
        return palette
    return {key: _with_palette(v, palette) if isinstance(v, dict) else v for key, v in description.items()}


def _normals(solid: Solid) -> Floats:
    corners = solid.points[solid.faces]
    facing = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    # Points in one place share a normal, so that a closed ring has no seam.
    _, same = np.unique(np.round(solid.points, 5), axis=0, return_inverse=True)
    same = same.reshape(-1)
    total = np.zeros((int(same.max()) + 1, 3))
    for i in range(3):
        np.add.at(total, same[solid.faces[:, i]], facing)
    total /= np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-12)
    return np.asarray(total[same])


@dataclass(frozen=True, eq=False)
class Panel:
    """A luminous rectangle: its centre (3,), half its longer side and half its shorter side as vectors (3,)."""

    centre: Floats
    along: Floats
    across: Floats


@dataclass
class Stage:
    """Geometry by material, while a scene is being built."""

    materials: dict[str, dict[str, Any]] = field(default_factory=dict)
    solids: dict[str, list[Solid]] = field(default_factory=dict)
    lamps: list[tuple[Solid, dict[str, Any], float]] = field(default_factory=list)
    panels: list[Panel] = field(default_factory=list)

    def material(self, name: str, bsdf: dict[str, Any]) -> None:
        """Declare a material."""
        self.materials[name] = bsdf

    def add(self, name: str, *solids: Solid) -> None:
        """Put solids of a material there."""
        self.solids.setdefault(name, []).extend(solids)

    def lamp(self, solid: Solid, radiance: dict[str, Any], power: float = 1.0) -> None:
        """Put a luminous surface there; it shines from its front, and of the paths' samples gets its share of power."""
        self.lamps.append((solid, radiance, power))

    def objects(self) -> dict[str, Any]:
        """Return the meshes: one for each material and smoothness, one for each lamp."""
        made: dict[str, Any] = {}
        for name, solids in self.solids.items():
            for smooth in (False, True):
                chosen = [s for s in solids if s.smooth == smooth]
                if chosen:
                    made[f"{name}_{int(smooth)}"] = mesh(join(chosen), self.materials[name])
        for number, (solid, radiance, power) in enumerate(self.lamps):
            made[f"lamp_{number}"] = mesh(solid, matt(colour_of((0.6, 0.6, 0.6))), radiance, power)
        return made
