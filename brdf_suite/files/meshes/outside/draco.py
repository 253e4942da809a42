"""Draco's bitstream, by DracoPy: the chunks of a glTF file behind each other."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from brdf_suite.files.meshes.outside.child import import_library
from brdf_suite.files.meshes.outside.values import ReadMesh, ReadPart, Refused
from brdf_suite.regular_files import read_bytes

DracoPy = import_library("draco")


def read(file: Path, options: dict[str, Any]) -> ReadMesh:
    """Return a part for each chunk: its faces, and each attribute by the number that glTF refers to."""
    content, at, parts = read_bytes(file), 0, []
    for length in options["lengths"]:
        try:
            mesh = DracoPy.decode(content[at : at + length])
        except (ValueError, RuntimeError, DracoPy.FileTypeException, AttributeError) as error:
            raise Refused("its Draco compression is damaged") from error
        at += length
        faces = getattr(mesh, "faces", None)
        if faces is None:
            raise Refused("its Draco compression holds points, not triangles")
        arrays = {"faces": np.asarray(faces, np.uint32).reshape(-1, 3)}
        for attribute in mesh.attributes:
            values = np.asarray(attribute["data"])
            arrays[f"attribute {attribute['unique_id']}"] = values.reshape(len(mesh.points), -1)
        parts.append(ReadPart(arrays))
    return ReadMesh(parts)
