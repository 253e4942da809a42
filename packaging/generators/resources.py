"""Write the packaged resources: paints, meshes, lights, baked occlusion, filtered maps, thumbnails.

Run without an argument for all that it can write, or name the kinds::

    python packaging/generators/resources.py [paints] [meshes] [environments] [occlusion] [lobe_maps] [thumbnails]

The environments that are path-traced take hours and Mitsuba; ``traced_environments.py`` writes them.

All else is computed, nothing is drawn at random without a fixed seed: the same code writes the same files.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

RESOURCES = Path(__file__).resolve().parents[2] / "resources"


def paints(folder: Path) -> Iterator[Path]:
    """Write the paints."""
    from paints import generate

    yield from generate(folder)


def meshes(folder: Path) -> Iterator[Path]:
    """Write the generated forms and the car."""
    from meshes.car import car
    from meshes.forms import panel, speed_form, sphere

    from brdf_suite.files.meshes.reading import write_mesh_glb

    for form in (speed_form, sphere, panel, car):
        mesh = form()
        path = folder / f"{mesh.name}.glb"
        write_mesh_glb(mesh, path)
        yield path


def environments(folder: Path) -> Iterator[Path]:
    """Write the generated environments."""
    from brdf_suite.files.images.environments import write_exr
    from brdf_suite.lighting.procedural import booth, overcast, sunny

    for make in (booth, sunny, overcast):
        environment = make()
        path = folder / f"{environment.name}.exr"
        write_exr(path, environment.stored(), metadata={"comments": environment.comment})
        yield path


def occlusion(folder: Path) -> Iterator[Path]:
    """Write what is baked for the surface that a new user sees first, named as it is looked up."""
    from brdf_suite.files.meshes.occlusion_cache import ENDING, encode_baked, occlusion_key
    from brdf_suite.pipeline.scene import default_view, load_surface
    from brdf_suite.surface.occlusion.bake import bake

    mesh = load_surface(default_view().surface)
    path = folder / f"{occlusion_key(mesh)}{ENDING}"
    for old in folder.glob(f"*{ENDING}"):
        old.unlink()
    path.write_bytes(b"".join(encode_baked(mesh, bake(mesh))))
    yield path


def lobe_maps(folder: Path) -> Iterator[Path]:
    """Write the filtered maps of the light that a new user sees first, for small pictures, and of the light booth.

    Those of the whole of a traced environment would be several times as large as all else; the small ones are seen
    while they are made.
    """
    from brdf_suite.lighting.environment import SMALL_COLUMNS
    from brdf_suite.lighting.filter.lobe_maps import prefilter
    from brdf_suite.lighting.lobe_map_cache import PACKAGED_ENDING, cache_key, pack_maps
    from brdf_suite.pipeline.environments import read_environment
    from brdf_suite.pipeline.scene import (
        default_view,
        find_environment,
        map_exponents,
        narrowed,
    )

    for old in folder.glob(f"*{PACKAGED_ENDING}"):
        old.unlink()
    first, booth = (find_environment(name) for name in (default_view().environment, "booth"))
    whole = read_environment(booth[1])
    lights = [(first[0], narrowed(read_environment(first[1]), SMALL_COLUMNS))]
    lights += [(booth[0], whole), (booth[0], narrowed(whole, SMALL_COLUMNS))]
    for name, light in lights:
        key = cache_key(light, map_exponents())
        path = folder / f"{key}{PACKAGED_ENDING}"
        path.write_bytes(pack_maps(prefilter(light, map_exponents()), key, name))
        yield path


def thumbnails(folder: Path) -> Iterator[Path]:
    """Write the pictures by which lights and forms are chosen; it needs OpenGL."""
    from thumbnails import generate

    yield from generate(folder)


KINDS: dict[str, Callable[[Path], Iterator[Path]]] = {
    "paints": paints,
    "meshes": meshes,
    "environments": environments,
    "occlusion": occlusion,
    "lobe_maps": lobe_maps,
    "thumbnails": thumbnails,
}


def main() -> int:
    """Write the kinds that the command line names."""
    parser = argparse.ArgumentParser(description="Write the packaged resources.")
    parser.add_argument("kinds", nargs="*", metavar="KIND", help=f"any of {', '.join(KINDS)}; none means all")
    parser.add_argument("--output", type=Path, default=RESOURCES, help="folder that holds the kinds' folders")
    arguments = parser.parse_args()
    unknown = sorted(set(arguments.kinds) - set(KINDS))
    if unknown:
        parser.error(f"{unknown[0]!r} is none of {', '.join(KINDS)}")
    for kind in arguments.kinds or KINDS:
        folder = arguments.output / kind
        folder.mkdir(parents=True, exist_ok=True)
        start = time.perf_counter()
        for path in KINDS[kind](folder):
            taken, start = time.perf_counter() - start, time.perf_counter()
            name = path.relative_to(arguments.output).as_posix()
            print(f"{name}: {path.stat().st_size / 1024:,.0f} KiB, {taken:.1f} s", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
