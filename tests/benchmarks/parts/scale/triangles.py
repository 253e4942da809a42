"""Load a mesh of so many triangles and draw its first frame, as Viewer does; a process of ``bench scale``.

The mesh is a wavy ball, written as another program's binary glTF, with normals and texture coordinates, or as PLY
without both. Prints one JSON object.
"""

from __future__ import annotations

import json
import struct
import sys
import tempfile
from dataclasses import replace
from pathlib import Path
from time import perf_counter, process_time

import numpy as np

from brdf_suite.cli.tools.bench import load_module

_turns = load_module(Path(__file__).with_name("turns.py"))

SIZE = (1280, 720)


def wavy_ball(triangles: int):
    """Return positions, normals (n, 3), texture coordinates (n, 2) and triangles (k, 3), about so many, of a ball."""
    rings = max(2, round(np.sqrt(triangles / 4.0)))
    theta, phi = np.meshgrid(
        np.linspace(0.001, np.pi - 0.001, rings + 1),
        np.linspace(0.0, 2.0 * np.pi, 2 * rings + 1),
        indexing="ij",
    )
    radius = 0.5 + 0.01 * np.sin(12.0 * theta) * np.sin(12.0 * phi)
    ray = np.stack([np.sin(theta) * np.sin(phi), np.cos(theta), np.sin(theta) * np.cos(phi)], axis=-1)
    positions = (radius[..., None] * ray).reshape(-1, 3)
    uvs = np.stack([phi, theta], axis=-1).reshape(-1, 2)
    across = 2 * rings + 1
    corner = (np.arange(rings)[:, None] * across + np.arange(2 * rings)).reshape(-1, 1)
    halves = np.array([[0, across, 1], [1, across, across + 1]])
    faces = np.concatenate([corner + half for half in halves])
    return positions, ray.reshape(-1, 3), uvs, faces


def write_glb(path: Path, triangles: int) -> None:
    """Write the ball as the binary glTF of another program."""
    positions, normals, uvs, faces = wavy_ball(triangles)
    arrays = [
        positions.astype("<f4"),
        normals.astype("<f4"),
        uvs.astype("<f4"),
        faces.astype("<u4").reshape(-1),
    ]
    views, accessors, start = [], [], 0
    for array, kind in zip(arrays, ("VEC3", "VEC3", "VEC2", "SCALAR"), strict=True):
        views.append({"buffer": 0, "byteOffset": start, "byteLength": array.nbytes})
        component = 5125 if kind == "SCALAR" else 5126
        accessors.append(
            {"bufferView": len(views) - 1, "componentType": component, "count": len(array), "type": kind}
        )
        start += array.nbytes
    accessors[0] |= {"min": arrays[0].min(axis=0).tolist(), "max": arrays[0].max(axis=0).tolist()}
    attributes = {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "ball"}],
        "meshes": [{"primitives": [{"attributes": attributes, "indices": 3}]}],
        "buffers": [{"byteLength": start}],
        "bufferViews": views,
        "accessors": accessors,
    }
    head = json.dumps(document).encode()
    head += b" " * (-len(head) % 4)
    body = b"".join(array.tobytes() for array in arrays)
    chunks = struct.pack("<II", len(head), 0x4E4F534A) + head
    chunks += struct.pack("<II", len(body), 0x004E4942) + body
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)


def write_ply(path: Path, triangles: int) -> None:
    """Write points and triangles alone, as scanners do."""
    positions, _, _, faces = wavy_ball(triangles)
    rows = np.zeros(len(faces), np.dtype([("count", "u1"), ("corners", "<i4", 3)]))
    rows["count"], rows["corners"] = 3, faces
    head = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {len(positions)}\n"
        "property float x\nproperty float y\nproperty float z\n"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    path.write_bytes(head.encode() + positions.astype("<f4").tobytes() + rows.tobytes())


def main(kind: str, triangles: int) -> None:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"ball.{kind}"
        (write_glb if kind == "glb" else write_ply)(path, triangles)
        sys.stdout.write(json.dumps(measure(path)) + "\n")


def measure(path: Path) -> dict[str, object]:
    import trimesh  # noqa: F401 - what the first mesh of another program imports is no matter of its size

    from brdf_suite.output.still import loaded_scene
    from brdf_suite.pipeline.lobe_fit import fit_material
    from brdf_suite.pipeline.material import default_paint, load_material
    from brdf_suite.pipeline.scene import default_view
    from brdf_suite.pipeline.surface import load_shaped
    from brdf_suite.realtime.pictures.moving import Pace

    view = replace(default_view(), surface="sphere")
    with loaded_scene(view) as loaded:
        scene = loaded.scene
        scene.set_material(fit_material(load_material(default_paint().name)))
        target = scene.renderer.context.simple_framebuffer(SIZE)
        pace = Pace()
        pace.begin_frame()
        drawn = perf_counter()
        scene.draw(loaded.composed(view, SIZE), target, SIZE)
        scene.renderer.context.finish()
        pace.end_frame(1e3 * (perf_counter() - drawn))
        began, cpu = perf_counter(), process_time()
        mesh = load_shaped(str(path), view.surface_look)
        read, read_cpu = perf_counter(), process_time() - cpu
        scene.set_surface(mesh)
        handed = perf_counter()
        pace.arrive(mesh.triangle_count)
        coarseness = pace.begin_frame()
        scene.draw(loaded.composed(view, SIZE), target, SIZE, coarseness)
        scene.renderer.context.finish()
        ended, cpu = perf_counter(), process_time() - cpu
        scene.draw(loaded.composed(view, SIZE), target, SIZE)
        scene.renderer.context.finish()
        whole = perf_counter()
    return {
        "triangles": mesh.triangle_count,
        "read_s": read - began,
        "read_cpu_s": read_cpu,
        "handed_over_s": handed - read,
        "draw_s": ended - handed,
        "first_frame_s": ended - began,
        "first_frame_scale": coarseness.scale,
        "whole_frame_s": whole - began,
        "cpu_s": cpu,
        "memory_mb": _turns.resident_mb("VmHWM"),
    }


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
