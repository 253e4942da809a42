"""Pictures: environments, maps and masks, photographs, compared pictures, colour profiles, stored renders."""

from __future__ import annotations

import importlib.util
import struct
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import OpenEXR
import tifffile
from PIL import Image

from brdf_suite.acquisition.photographs.reading import photograph_facts, read_photograph
from brdf_suite.acquisition.simulator.folder import write_photograph
from brdf_suite.appearance.colour.spaces import SPACES
from brdf_suite.documents.studio import Backdrop, Sky, Studio, StudioLamp, load_light, save_light
from brdf_suite.errors import FileError
from brdf_suite.files.images.icc import profile_bytes, read_display_profile
from brdf_suite.files.images.pictures import PICTURE_FORMATS
from brdf_suite.files.images.relief import read_mask, read_normal_map, read_tangent_map
from brdf_suite.files.palettes.cmyk_profile import read_profile
from brdf_suite.lighting.procedural import sky, studio
from brdf_suite.output.compared import read_compared_picture
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.reference.estimate_file import read_estimate, write_estimate
from brdf_suite.reference.passes import Estimate
from brdf_suite.reference.raytraced.picture import Sums, read_sums, write_sums
from brdf_suite.regular_files import read_bytes
from tools.attack.readers.reader import MEGABYTE, Reader, WrongValueError

_SHAPE = (32, 64)
_PRIMARIES = "0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329"
Make = Callable[[Path], list[Path]]


def _planes(kind: type = np.float32) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(1)
    return {name: (4.0 * rng.random(_SHAPE)).astype(kind) for name in "RGB"}


def _exr(folder: Path) -> list[Path]:
    """Write small OpenEXR files of common and rare kinds."""
    light = _planes()
    rng = np.random.default_rng(2)
    lines = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    tiles: dict[str, Any] = {"compression": OpenEXR.PIZ_COMPRESSION, "type": OpenEXR.tiledimage}
    tiles["tiles"] = OpenEXR.TileDescription()
    cube = {name: (4.0 * rng.random((96, 16))).astype(np.float32) for name in "RGB"}
    beauty = [
        OpenEXR.Part(dict(lines), {"Z": light["R"]}, name="depth"),
        OpenEXR.Part(dict(tiles), dict(light), name="beauty"),
    ]
    written = {
        "lines": OpenEXR.File(dict(lines), dict(light)),
        "tiled": OpenEXR.File(tiles, dict(light)),
        "one_channel": OpenEXR.File(dict(lines), {"Y": light["R"]}),
        "half_b44": OpenEXR.File({**lines, "compression": OpenEXR.B44_COMPRESSION}, _planes(np.float16)),
        "dwaa": OpenEXR.File({**lines, "compression": OpenEXR.DWAA_COMPRESSION}, dict(light)),
        "cube": OpenEXR.File({**lines, "envmap": OpenEXR.ENVMAP_CUBE}, cube),
        "parts": OpenEXR.File(beauty),
    }
    for name, file in written.items():
        file.write(str(folder / f"{name}.exr"))
    colour = np.stack([light[name] + 0.5 for name in "RGB"], axis=2)
    chroma = _test_module("tests/files/images/test_exr_kinds.py").chroma_file(folder / "chroma.exr", colour)
    return [*(folder / f"{name}.exr" for name in written), chroma]


def _test_module(name: str) -> Any:
    """Return a module of the tests that writes what no library writes."""
    path = Path(__file__).parents[3] / name
    spec = importlib.util.spec_from_file_location(f"attack_{path.stem}", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def _hdr(folder: Path) -> list[Path]:
    """Write a Radiance file with runs and one without."""
    height, width = 8, 16
    head = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=1.0\nPRIMARIES={_PRIMARIES}\n\n-Y {height} +X {width}\n"
    rng = np.random.default_rng(1)
    flat = rng.integers(100, 140, (height, width, 4), dtype=np.uint8)
    (folder / "flat.hdr").write_bytes(head.encode() + flat.tobytes())
    line = b"\2\2\0" + bytes([width])
    for plane in range(3):
        line += bytes([width]) + flat[0, :, plane].tobytes()
    (folder / "runs.hdr").write_bytes(head.encode() + (line + bytes([128 + width, 128])) * height)
    return [folder / "flat.hdr", folder / "runs.hdr"]


def _read_environment(path: Path) -> None:
    radiance = read_environment(path).radiance
    if not np.isfinite(radiance).all() or float(radiance.min()) < 0.0:
        raise WrongValueError("no radiance")
    if path.suffix == ".exr":
        read_compared_picture(path)


def _studios(folder: Path) -> list[Path]:
    lamp = StudioLamp("ring", (0.0, 2.0, 1.0), (1.0, 0.2), colour_temperature_k=3000.0)
    save_light(Studio("small", (lamp,), backdrop=Backdrop(0.1)), folder / "ring.brdfstudio")
    save_light(Sky("sky"), folder / "sky.brdfstudio")
    return [folder / "ring.brdfstudio", folder / "sky.brdfstudio"]


def _read_light(path: Path) -> None:
    # At its size of 1,024 × 512 the drawing of thousands would take a day.
    light = load_light(path)
    made = sky(light, height=8, samples=1) if isinstance(light, Sky) else studio(light, height=8, samples=1)
    if not np.isfinite(made.radiance).all():
        raise WrongValueError("no radiance")


def _normals(side: int = 16) -> np.ndarray:
    rng = np.random.default_rng(3)
    normals = rng.normal((0.0, 0.0, 2.0), 0.3, (side, side, 3))
    return np.asarray(normals / np.linalg.norm(normals, axis=-1, keepdims=True))


def _pictures(kind: str) -> Make:
    def make(folder: Path) -> list[Path]:
        codes = np.rint(127.5 * (_normals() + 1.0)).astype(np.uint8)
        ending = {"JPEG": "jpg", "TIFF": "tif"}.get(kind, kind.lower())
        picture = Image.fromarray(codes)
        paths = [folder / f"colour.{ending}", folder / f"grey.{ending}"]
        options: dict[str, Any] = {"compression": "tiff_deflate"} if kind == "TIFF" else {}
        picture.save(paths[0], kind, **options)
        picture.convert("L").save(paths[1], kind)
        if kind in ("PNG", "TIFF"):
            paths += [folder / f"palette.{ending}", folder / f"deep.{ending}"]
            picture.convert("P").save(paths[2], kind)
            Image.fromarray(codes[..., 0].astype(np.uint16) * 257).save(paths[3], kind)
        return paths

    return make


def _relief_exr(folder: Path) -> list[Path]:
    planes = {name: _normals()[..., index].astype(np.float32) for index, name in enumerate("RGB")}
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(header, planes).write(str(folder / "normals.exr"))
    return [folder / "normals.exr"]


def _read_maps(path: Path) -> None:
    """Read as a mask, as a normal map and as a tangent map: the last two may refuse what the first reads."""
    found = [read_mask(path)]
    for read in (read_normal_map, read_tangent_map):
        try:
            found.append(read(path))
        except FileError as error:
            if "map" not in str(error):
                raise
    if not all(np.isfinite(one).all() for one in found):
        raise WrongValueError("numbers that are not finite")
    if path.suffix == ".png":
        read_compared_picture(path)


def _photographs(ending: str) -> Make:
    def make(folder: Path) -> list[Path]:
        codes = np.random.default_rng(7).integers(0, 60000, (12, 16, 3), dtype=np.uint16)
        if ending == "tif":
            paths = [folder / f"{name}.tif" for name in ("plain", "eight", "deflate", "tiled", "predictor")]
            write_photograph(paths[0], codes, 0.01)
            write_photograph(paths[1], (codes >> 8).astype(np.uint8), 0.01)
            tifffile.imwrite(paths[2], codes, photometric="rgb", compression="zlib", rowsperstrip=4)
            tifffile.imwrite(paths[3], codes, photometric="rgb", tile=(16, 16))
            tifffile.imwrite(paths[4], codes, photometric="rgb", compression="zlib", predictor=True)
            return paths
        path = folder / f"photograph.{ending}"
        if ending == "dng":
            mosaic = np.full((64, 64), 1064)
            path.write_bytes(
                _test_module("tests/acquisition/test_photographs.py")._dng(mosaic, black=64, white=4095)
            )
        elif ending == "jpg":
            Image.fromarray((codes >> 8).astype(np.uint8)).save(path, "JPEG")
        elif ending in ("exr", "hdr"):
            source = (_exr if ending == "exr" else _hdr)(folder)
            return source[:2]
        else:
            write_photograph(path, codes, 0.01)
        return [path]

    return make


def _read_photograph(path: Path) -> None:
    photograph_facts(path)
    if read_photograph(path).codes.ndim != 3:
        raise WrongValueError("no picture")


def _read_display(path: Path) -> None:
    read_display_profile(read_bytes(path), path.name)


# L*a*b* of a screen's eight corners, from black, blue and green to white.
_CORNERS = (
    *((0, 0, 0), (32, 79, -108), (88, -86, 83), (91, -48, -14)),
    *((53, 80, 67), (60, 98, -61), (97, -22, 94), (100, 0, 0)),
)


def _profiles(folder: Path) -> list[Path]:
    paths = []
    for name, space in SPACES.items():
        paths.append(folder / f"{name.replace(' ', '_').replace('/', '_')}.icc")
        paths[-1].write_bytes(profile_bytes(space))
    towards = bytes(
        round(number) for lab in _CORNERS for number in (2.55 * lab[0], lab[1] + 128, lab[2] + 128)
    )
    back = bytes(np.random.default_rng(2).integers(0, 255, 8 * 3, dtype=np.uint8))
    paths.append(folder / "tables.icc")
    paths[-1].write_bytes(
        _table_profile(b"mntr", b"RGB ", {b"A2B0": _lut8(3, towards), b"B2A0": _lut8(3, back)})
    )
    return paths


def _cmyk_profile(folder: Path) -> list[Path]:
    """Write a profile of inks: one table of 2 × 2 × 2 × 2 nodes to Lab."""
    table = _lut8(4, bytes(np.random.default_rng(1).integers(0, 255, 16 * 3, dtype=np.uint8)))
    (folder / "inks.icc").write_bytes(_table_profile(b"prtr", b"CMYK", {b"A2B0": table, b"A2B1": table}))
    return [folder / "inks.icc"]


def _lut8(channels: int, nodes: bytes) -> bytes:
    """Return a table of 2 nodes a channel, to 3 channels (ICC.1:2022, lut8Type)."""
    identity = bytes(range(256))
    matrix = struct.pack(">9i", 65536, 0, 0, 0, 65536, 0, 0, 0, 65536)
    return (
        b"mft1" + bytes(4) + bytes([channels, 3, 2, 0]) + matrix + identity * channels + nodes + identity * 3
    )


def _table_profile(kind: bytes, device: bytes, tables: dict[bytes, bytes]) -> bytes:
    """Return a profile of tables that connects by Lab."""
    tags = tables | {b"wtpt": b"XYZ \0\0\0\0" + struct.pack(">3i", 63190, 65536, 54061)}
    listed, data, start = b"", b"", 132 + 12 * len(tags)
    for name, content in tags.items():
        listed += struct.pack(">4sII", name, start + len(data), len(content))
        data += content + bytes(-len(content) % 4)
    head = struct.pack(
        ">I4sI4s4s4s12s4s", start + len(data), b"", 0x02400000, kind, device, b"Lab ", b"", b"acsp"
    )
    white_d50 = struct.pack(">3i", 63190, 65536, 54061)
    return (head + bytes(28) + white_d50).ljust(128, b"\0") + struct.pack(">I", len(tags)) + listed + data


def _estimates(folder: Path) -> list[Path]:
    rng = np.random.default_rng(1)
    light, cover = rng.random((6, 8, 3)), rng.random((6, 8))
    write_estimate(folder / "estimate.exr", Estimate(light, cover, light, 8, 2, 1.0), light, "key")
    return [folder / "estimate.exr"]


def _sums(folder: Path) -> list[Path]:
    rng = np.random.default_rng(1)
    write_sums(folder / "sums.exr", Sums(rng.random((6, 8, 7)), 4), rng.random((6, 8, 3)), "key")
    return [folder / "sums.exr"]


LARGE = 1024 * MEGABYTE
READERS = [
    Reader("environment:exr", _read_environment, _exr, memory=LARGE),
    Reader("environment:hdr", _read_environment, _hdr, memory=LARGE),
    Reader("environment:studio", _read_light, _studios),
    *(Reader(f"map:{kind.lower()}", _read_maps, _pictures(kind), memory=LARGE) for kind in PICTURE_FORMATS),
    Reader("map:exr", _read_maps, _relief_exr, memory=LARGE),
    *(
        Reader(f"photograph:{ending}", _read_photograph, _photographs(ending), memory=LARGE)
        for ending in ("png", "tif", "jpg", "exr", "hdr", "dng")
    ),
    Reader("profile:display", _read_display, _profiles),
    Reader("profile:cmyk", read_profile, _cmyk_profile),
    Reader("render:estimate", lambda path: read_estimate(path, "key"), _estimates, memory=LARGE),
    Reader("render:sums", lambda path: read_sums(path, "key"), _sums, memory=LARGE),
]
