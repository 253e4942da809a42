"""Cost of one environment, one measured file, one scene graph or one studio of lamps; a process of ``bench scale``.

Prints one JSON object with seconds, and the processor's seconds of all threads.
"""

from __future__ import annotations

import json
import sys
import tempfile
from pathlib import Path
from statistics import median
from time import perf_counter, process_time

import numpy as np

from brdf_suite.cli.tools.bench import load_module

_turns = load_module(Path(__file__).with_name("turns.py"))


def timed(act, runs=1):
    """Return the medians of seconds and of the processor's seconds."""
    times = []
    for _ in range(runs):
        wall, processor = perf_counter(), process_time()
        act()
        times.append((perf_counter() - wall, process_time() - processor))
    return {"s": median(t for t, _ in times), "cpu_s": median(t for _, t in times)}


def environment(width: int, folder: Path):
    """Read an environment image of ``width`` columns and filter it, nothing being cached."""
    from brdf_suite.files.images.exr.image import write_exr
    from brdf_suite.pipeline.environments import read_environment
    from brdf_suite.pipeline.scene import load_environment

    rows = np.sin(np.linspace(0.0, np.pi, width // 2))[:, None, None]
    columns = 1.0 + np.cos(np.linspace(0.0, 40.0 * np.pi, width))[None, :, None]
    path = folder / "light.exr"
    write_exr(path, (rows * columns * np.array([1.0, 0.9, 0.8])).astype(np.float16))
    load_environment("booth")  # what is done once
    read = timed(lambda: read_environment(path))
    whole = timed(lambda: load_environment(str(path)))
    return {**whole, "read_s": read["s"], "read_cpu_s": read["cpu_s"]}


def samples(count: int, folder: Path):
    """Read a file of so many goniometer readings."""
    from brdf_suite.files.measured import read_measured

    path = folder / "readings.astm"
    side = max(2, round(np.sqrt(count / 10)))
    theta_i = np.linspace(0.05, 1.2, 10)
    theta_s, phi_s = np.meshgrid(np.linspace(0.02, 1.4, side), np.linspace(0.0, 6.2, side), indexing="ij")
    with path.open("w", encoding="ascii") as file:
        file.write(f"SAMPLE_NAME scale\nNUM_POINTS {10 * side * side}\n")
        file.write("VARS theta_i,phi_i,theta_s,phi_s,R,G,B\n")
        for angle in theta_i:
            rows = np.column_stack(
                [np.full(side * side, angle), np.zeros(side * side), theta_s.ravel(), phi_s.ravel()]
            )
            value = 0.1 + 0.05 * np.cos(rows[:, 2] - angle)
            np.savetxt(file, np.column_stack([rows, value, value, value]), fmt="%.6g", delimiter=",")
    return timed(lambda: read_measured(path))


def nodes(count: int, folder: Path):
    """Read a glTF file of so many nodes, each below the one before, that all show one triangle."""
    from brdf_suite.files.meshes.reading import read_mesh

    triangle = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], "<f4").tobytes()
    (folder / "one.bin").write_bytes(triangle)
    chain = [
        {"mesh": 0, "translation": [1e-4, 0.0, 0.0], **({"children": [n + 1]} if n + 1 < count else {})}
        for n in range(count)
    ]
    document = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": chain,
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36, "uri": "one.bin"}],
    }
    path = folder / "chain.gltf"
    path.write_text(json.dumps(document), encoding="ascii")
    return timed(lambda: read_mesh(path), 3)


def lamps(count: int, _folder: Path):
    """Draw the light of a studio with so many lamps, as after each edit that is to stay."""
    from brdf_suite.documents.studio import BoothRoom, Studio, StudioLamp
    from brdf_suite.lighting.procedural.studio import studio

    turns = np.linspace(0.0, 6.0, count)
    description = Studio(
        "Scale",
        tuple(
            StudioLamp("box", (float(3.0 * np.cos(turn)), 2.0, float(3.0 * np.sin(turn))), (0.3, 0.3))
            for turn in turns
        ),
        BoothRoom(),
    )
    studio(description, 64)
    return timed(lambda: studio(description), 3)


COSTS = {"environment": environment, "samples": samples, "nodes": nodes, "lamps": lamps}


def main(name: str, size: int) -> None:
    with tempfile.TemporaryDirectory() as folder:
        found = COSTS[name](size, Path(folder))
    sys.stdout.write(json.dumps({**found, "memory_mb": _turns.resident_mb("VmHWM")}) + "\n")


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
