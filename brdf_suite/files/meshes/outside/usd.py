"""Universal Scene Description (``.usd``, ``.usda``, ``.usdc``, ``.usdz``), by Pixar's usd-core.

Sources: OpenUSD, UsdGeom and UsdPreviewSurface. Meshes that are drawn are read, with those of instances; subsets of
other materials are parts of their own. Of a subdivision surface the cage is read; curves, points and solids are not.
Layers that a stage is composed of are read where they lie in the folder of the file or below. Value clips, which hold
animation, are not read.
"""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from brdf_suite.errors import FileError
from brdf_suite.files.meshes.outside.child import import_library
from brdf_suite.files.meshes.outside.values import ReadMesh, ReadPart, Refused, named
from brdf_suite.regular_files import check_regular, exists, find_inside

import_library("usd")
Ar, Sdf, Tf, Usd, UsdGeom, UsdShade = (
    import_module(f"pxr.{name}") for name in ("Ar", "Sdf", "Tf", "Usd", "UsdGeom", "UsdShade")
)

_MOST_LAYERS = 10_000
_NOT_DRAWN = ("guide", "proxy")
_BASE_INPUTS = {
    "colour": "diffuseColor",
    "metallic": "metallic",
    "roughness": "roughness",
    "passing": "opacity",
}


def read(file: Path, options: dict[str, Any]) -> ReadMesh:
    """Return the meshes of the stage at the time that it starts with."""
    parts: list[ReadPart] = []
    try:
        # Without links: the library looks for other layers beside the file as it is named.
        opened = named(file.resolve(), options["kind"], "usd")
        context = Ar.GetResolver().CreateDefaultContextForAsset(str(opened))
        with Ar.ResolverContextBinder(context):
            layers = _layers(opened)  # kept, so that the stage takes them as they are, without clips
        stage = Usd.Stage.Open(layers[0], context)
        matrices = UsdGeom.XformCache()
        for prim in stage.Traverse(Usd.TraverseInstanceProxies()):
            if prim.IsA(UsdGeom.Mesh) and _is_drawn(prim):
                matrix = np.array(matrices.GetLocalToWorldTransform(prim), np.float64)
                parts += _parts(UsdGeom.Mesh(prim), matrix)
        up = "z" if UsdGeom.GetStageUpAxis(stage) == UsdGeom.Tokens.z else "y"
        return ReadMesh(parts, up, UsdGeom.GetStageMetersPerUnit(stage))
    except (Tf.ErrorException, RuntimeError, ValueError, TypeError, OverflowError, OSError) as error:
        raise Refused("damaged, or refers to files that are not there") from error


def _layers(file: Path) -> list[Any]:
    """Open the layer of a file and all those that a stage of it is composed of; return them, without value clips.

    Raises :class:`Refused`: one of them is not a regular file in the folder of the file or below.
    """
    layers = [Sdf.Layer.FindOrOpen(str(file))]
    if layers[0] is None:
        raise ValueError("no layer")
    seen = set(layers)
    for layer in layers:
        _remove_clips(layer)
        for name in layer.GetCompositionAssetDependencies():
            _check_reference(layer, name, file.parent)
            other = Sdf.Layer.FindOrOpenRelativeToLayer(layer, name)
            if other and other not in seen:
                seen.add(other)
                layers.append(other)
            if len(layers) > _MOST_LAYERS:
                raise Refused(f"refers to more than {_MOST_LAYERS:,} other files")
    return layers


def _check_reference(layer: Any, name: str, folder: Path) -> None:
    """Refuse what a layer names, if need be, before anything opens it."""
    # In a package, too: what would lead out of the package leads out of its folder.
    start = Path(Sdf.Layer.SplitIdentifier(layer.identifier)[0]).parent
    is_named_inside = not name.startswith("`") and find_inside(folder, _outer(name), start) is not None
    # An expression may name anything; a name without "./" may be found elsewhere.
    file = Path(_outer(layer.ComputeAbsolutePath(name))) if is_named_inside else None
    if file is None or (file.is_absolute() and not file.resolve().is_relative_to(folder)):
        raise Refused(f"refers to {name[:80]}, which is not in its folder")
    if file.is_absolute():
        try:
            if exists(file):  # what is not there is left out
                check_regular(file)
        except FileError as error:
            raise Refused(f"needs {file.name} beside it, which {error.reason}") from error


def _outer(name: str) -> str:
    """Return the file that the name of a layer begins with: a package, or the layer itself."""
    file: str = Sdf.Layer.SplitIdentifier(name)[0]
    return str(Ar.SplitPackageRelativePathOuter(file)[0]) if Ar.IsPackageRelativePath(file) else file


def _remove_clips(layer: Any) -> None:
    """Remove value clips from a layer in memory: the library would open the files that they name."""

    def remove(path: Any) -> None:
        if path.IsPrimPath() or path.IsPrimVariantSelectionPath():
            prim = layer.GetPrimAtPath(path)
            if prim and prim.HasInfo("clips"):
                prim.ClearInfo("clips")

    layer.Traverse(Sdf.Path.absoluteRootPath, remove)


def _is_drawn(prim: Any) -> bool:
    imageable = UsdGeom.Imageable(prim)
    return (
        imageable.ComputeVisibility() != UsdGeom.Tokens.invisible
        and imageable.ComputePurpose() not in _NOT_DRAWN
    )


def _parts(mesh: Any, matrix: Any) -> Iterator[ReadPart]:
    """Yield the mesh, ``matrix`` its rows of OpenUSD (4, 4): a row vector comes before it."""
    points = _array(mesh.GetPointsAttr(), 3)
    counts = np.asarray(mesh.GetFaceVertexCountsAttr().Get() or (), np.int64)
    indices = np.asarray(mesh.GetFaceVertexIndicesAttr().Get() or (), np.int64)
    if points is None or not len(counts) or counts.min() < 0 or counts.sum() > len(indices):
        return
    indices = indices[: counts.sum()]
    if len(indices) == 0 or indices.min() < 0 or indices.max() >= len(points):
        return
    corners, faces = fans(counts)
    primvars = UsdGeom.PrimvarsAPI(mesh)
    values = {
        "normals": _at_corners(*_normals(mesh, primvars), indices, counts),
        "uvs": _at_corners(*_uvs(primvars), indices, counts),
    }
    positions = points
    triangles = indices[corners]
    if any(found is not None for found in values.values()):
        positions, triangles = points[indices], corners
    positions = positions @ matrix[:3, :3] + matrix[3, :3]
    if values["normals"] is not None and abs(np.linalg.det(matrix[:3, :3])) > 0.0:
        values["normals"] = values["normals"] @ np.linalg.inv(matrix[:3, :3]).T
    left = mesh.GetOrientationAttr().Get() == UsdGeom.Tokens.leftHanded
    if left != (np.linalg.det(matrix[:3, :3]) < 0.0):
        triangles = triangles[:, ::-1]
    name = str(mesh.GetPrim().GetName())
    arrays = {"positions": positions.astype(np.float32)}
    arrays |= {key: found.astype(np.float32) for key, found in values.items() if found is not None}
    whole = np.full(len(counts), -1)
    subsets = UsdShade.MaterialBindingAPI(mesh).GetMaterialBindSubsets()
    for number, subset in enumerate(subsets):
        chosen = np.asarray(subset.GetIndicesAttr().Get() or (), np.int64)
        whole[chosen[(chosen >= 0) & (chosen < len(counts))]] = number
    for number in range(-1, len(subsets)):
        of_it = triangles[whole[faces] == number]
        prim = mesh.GetPrim() if number < 0 else subsets[number].GetPrim()
        if len(of_it):
            title = name if number < 0 else f"{name}_{prim.GetName()}"
            yield ReadPart({**arrays, "triangles": of_it}, {"name": title, **_look(prim, mesh)})


def fans(counts: Any) -> tuple[Any, Any]:
    """Return the triangles (k, 3) of polygons as places in their list of corners, and the polygon of each (k,)."""
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]])
    faces = np.repeat(np.arange(len(counts)), np.maximum(counts - 2, 0))
    first = np.concatenate([[0], np.cumsum(np.maximum(counts - 2, 0))[:-1]])
    step = np.arange(len(faces)) - first[faces]
    begin = starts[faces]
    return np.stack([begin, begin + step + 1, begin + step + 2], axis=1), faces


def _array(attribute: Any, width: int) -> Any:
    values = attribute.Get()
    if values is None:
        values = attribute.Get(Usd.TimeCode.EarliestTime())
    array = np.asarray(values if values is not None else (), np.float64)
    return array.reshape(-1, width) if array.size and array.size % width == 0 else None


def _normals(mesh: Any, primvars: Any) -> tuple[Any, str]:
    primvar = primvars.GetPrimvar("normals")
    if primvar and primvar.HasValue():
        return np.asarray(primvar.ComputeFlattened(), np.float64), str(primvar.GetInterpolation())
    return _array(mesh.GetNormalsAttr(), 3), str(mesh.GetNormalsInterpolation())


def _uvs(primvars: Any) -> tuple[Any, str]:
    for primvar in primvars.GetPrimvarsWithValues():
        if "texCoord2" in str(primvar.GetTypeName()) or primvar.GetPrimvarName() in ("st", "UVMap", "uv"):
            values = np.asarray(primvar.ComputeFlattened(), np.float64)
            if values.ndim == 2 and values.shape[1] == 2:
                return values, str(primvar.GetInterpolation())
    return None, ""


def _at_corners(values: Any, interpolation: str, indices: Any, counts: Any) -> Any:
    """Return values at the corners of polygons, None where there are not as many as their interpolation wants."""
    if values is None:
        return None
    if interpolation in ("vertex", "varying") and len(values) > indices.max():
        return values[indices]
    if interpolation == "faceVarying" and len(values) == len(indices):
        return values
    if interpolation == "uniform" and len(values) == len(counts):
        return np.repeat(values, counts, axis=0)
    return None


def _look(prim: Any, mesh: Any) -> dict[str, Any]:
    material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
    if not material:
        shown = mesh.GetDisplayColorAttr().Get()
        colour = [float(channel) for channel in shown[0]] if shown is not None and len(shown) else None
        return {"material": "", "colour": colour}
    fields: dict[str, Any] = {"material": str(material.GetPrim().GetName())}
    shader, _, _ = material.ComputeSurfaceSource()
    for field, name in _BASE_INPUTS.items() if shader else ():
        given = shader.GetInput(name)
        if given and not given.HasConnectedSource() and given.Get() is not None:
            value = given.Get()
            fields[field] = [float(part) for part in value] if field == "colour" else float(value)
    if shader and shader.GetInput("diffuseColor") and shader.GetInput("diffuseColor").HasConnectedSource():
        fields["colour"] = None
    if "passing" in fields:
        fields["passing"] = 1.0 - fields["passing"]
    return fields
