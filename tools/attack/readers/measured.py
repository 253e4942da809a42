"""Measured reflectance: every registered format, a small file of each, read and evaluated."""

from __future__ import annotations

import contextlib
import json
import struct
from pathlib import Path

import numpy as np

from brdf_suite.arrays import AnyArray
from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint
from brdf_suite.documents.store import paint_to_json
from brdf_suite.errors import FileError
from brdf_suite.files.measured import FORMATS, read_measured, write_measured
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.files.measured.rgl import pack
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.factored.model import Factored
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples
from tools.attack.readers.reader import Reader, WrongValueError

LOBES = CookTorrancePaint("L", (0.1, 0.05, 0.02), (CookTorranceLobe((0.2, 0.3, 0.4), 0.3, 0.05),))
_TEXTS: dict[str, dict[str, str]] = {
    "astm": {
        "chip.astm": "NUM_POINTS 2\nVARS theta_i,phi_i,theta_s,phi_s,465nm,525nm,630nm\n"
        "0.1,0,0.2,3.0,0.5,0.25,0.125\n0.3,0,0.4,1.0,1,1,1\n"
    },
    "zemax": {
        "panel.bsdf": "Source Measured\nSymmetry PlaneSymmetrical\nSpectralContent XYZ\nScatterType BRDF\n"
        "SampleRotation 1\n0\nAngleOfIncidence 2\n0 30\nScatterAzimuth 2\n0 180\nScatterRadial 3\n0 20 80\n"
        + "".join(
            f"Tristimulus{axis}\nDataBegin\nTIS 0.5\n9 2 0.1\n9 2 0.1\nTIS 0.5\n8 2 0.1\n8 1 0\nDataEnd\n"
            for axis in "XYZ"
        )
    },
    "pgii": {"foil.dat": "#format: theta phi DSF\n#intheta 30\n#inphi 0\n60 180 0.5\n30 180 4.0\n150 0 9\n"},
    "alta": {
        "pair.alta": "#DIM 6 3\n#PARAM_IN CARTESIAN\n#PARAM_OUT RGB_COLOR\n0 0 1 0.6 0 0.8 1.0 0.5 0.2\n",
        "half.alta": "#DIM 4 1\n#VS 1\n#PARAM_IN RUSIN_TH_PH_TD_PD\n0.2 0.3 0.4 1.5 1.0 0.1\n0.2 0.3 0.5 1.5 1.0 0.1\n",
    },
    "ssdd": {
        "table.ssdd": "VERSION 0.2\n\nDATA_TYPE brdf\nCOLOR_MODEL rgb\nPARAM_TYPE spherical_coordinate_system\n"
        "PARAM0_LIST 0 45\nPARAM2_LIST 0 60\nPARAM3_LIST 0 180 360\nDATA ascii\n" + "0.3 0.2 0.1\n" * 12,
        "mirrored.ssdd": "VERSION 0.2\n\nDATA_TYPE brdf\nCOLOR_MODEL spectrum\nWAVELENGTH_LIST 450 550 650\n"
        "PARAM_TYPE specular_coordinate_system\nREDUCTION_TYPE bilateral_symmetry\nPARAM0_LIST 0 45\n"
        "PARAM2_LIST 0 30\nPARAM3_LIST 0 90 180\nDATA ascii\n" + "0.3 0.2 0.1\n" * 12,
    },
    "lighttools": {
        "panel.bsdf": "Symmetry Asymmetric\nSpectralContent XYZ\nScatterAzimuth 3\n0 180 360\nScatterRadial 2\n0 60\n"
        "DataBegin\n"
        + "".join(
            f"AOI {angle}\nPOI 0\nSide Front\nTristimulusValue Tris{axis}\nScatterType BRDF\nTIS 0.5\n"
            "0.1 0.2\n0.1 0.2\n0.1 0.2\n"
            for angle in (0, 45)
            for axis in "XYZ"
        )
        + "DataEnd\n"
    },
    "materialx": {
        "coat.mtlx": '<?xml version="1.0"?>\n<materialx version="1.39" colorspace="lin_rec709">\n'
        '  <open_pbr_surface name="s" type="surfaceshader">\n'
        '    <input name="base_color" type="color3" value="0.6, 0.1, 0.05"/>\n'
        '    <input name="coat_weight" type="float" value="0.8"/>\n  </open_pbr_surface>\n'
        '  <surfacematerial name="m" type="material">\n'
        '    <input name="surfaceshader" type="surfaceshader" nodename="s"/>\n  </surfacematerial>\n</materialx>\n'
    },
    "model_text": {
        "phong.brdf": "analytic\n::begin parameters\nfloat n 1 400 60\ncolor kd 0.2 0.3 0.6\n::end parameters\n"
        "::begin shader\nvec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y)\n{\n"
        "    return kd / 3.14159265 + vec3(pow(max(dot(N, normalize(L + V)), 0.0), n));\n}\n::end shader\n",
        "matt.py": "def brdf(L, V, N, X, Y, a=number(0, 1, 0.5)):\n    h = normalize(L + V)\n"
        "    return a / pi + max(dot(N, h), 0.0) ** 20\n",
    },
    "cook_torrance": {"lobes.brdfpaint": json.dumps(paint_to_json(LOBES))},
}


def _directions() -> tuple[np.ndarray, np.ndarray]:
    """A few pairs (n, 3), the mirror, grazing ones and one below the horizon among them."""
    theta_i = np.array([0.0, 0.8, 0.8, 1.5, 1.57, 0.3, 0.8])
    theta_o = np.array([0.0, 0.8, 0.3, 1.5, 0.2, 1.2, 2.0])
    phi = np.array([0.0, np.pi, 1.0, np.pi, 2.0, 4.0, 1.0])
    return spherical(theta_i, 0.3 * phi), spherical(theta_o, phi)


def _samples(bands: int = 0) -> ScatteredSamples:
    rng = np.random.default_rng(4)
    pairs = rng.normal(size=(2, 40, 3))
    pairs[..., 2] = np.abs(pairs[..., 2]) + 0.1
    pairs /= np.linalg.norm(pairs, axis=-1, keepdims=True)
    if bands:
        wavelengths = np.linspace(400.0, 700.0, bands)
        spectra = rng.random((40, bands))
        return ScatteredSamples(pairs[0], pairs[1], spectra[:, :3], spectra, wavelengths)
    return ScatteredSamples(pairs[0], pairs[1], rng.random((40, 3)))


def _write_rgl(path: Path) -> None:
    """Write a small material in the adaptive parameterization, isotropic, in colours."""
    rng = np.random.default_rng(3)
    one = np.ones((1, 8, 8), np.float32)
    fields: dict[str, AnyArray] = {
        "description": np.frombuffer(b"small", np.uint8),
        "phi_i": np.zeros(1, np.float32),
        "theta_i": np.linspace(0.0, 1.4, 3, dtype=np.float32),
        "sigma": np.ones((8, 8), np.float32),
        "ndf": np.ones((8, 8), np.float32),
        "vndf": np.repeat(one, 3, axis=0)[None],
        "luminance": np.repeat(one, 3, axis=0)[None],
        "rgb": rng.random((1, 3, 3, 8, 8)).astype(np.float32),
        "jacobian": np.array([1], np.uint8),
    }
    path.write_bytes(pack(fields))


def _write_polarized(path: Path) -> None:
    """Write a small table of Mueller matrices over the half vector, which depolarize all light."""
    shape = (3, 2, 2, 2)
    matrices = np.zeros((*shape, 4, 4), np.float32)
    matrices[..., 0, 0] = 0.2
    angles = {"theta_h": (0.0, 0.8), "theta_d": (0.0, 0.8), "phi_d": (0.0, np.pi, 2.0 * np.pi)}
    fields: dict[str, AnyArray] = {name: np.array([values], np.float32) for name, values in angles.items()}
    path.write_bytes(pack(fields | {"wvls": np.array((500, 600), np.uint16), "M": matrices}))


def _write_mbsdf(folder: Path) -> None:
    """Write small tables, in grey and in colour with transmission behind; those that the suite writes have 17 MB."""
    rng = np.random.default_rng(6)
    shapes = {"grey": (0, 5, 5, 6, 1), "colour": (1, 4, 4, 4, 3)}
    for name, (kind, *shape) in shapes.items():
        table = struct.pack("<3I", kind, shape[0], shape[2]) + rng.random(shape).astype("<f4").tobytes()
        content = b'NVIDIA ARC MBSDF V1\nname="small"\nMBSDF_DATA_REFLECTION=\n' + table
        if kind:
            content += b"\nMBSDF_DATA_TRANSMISSION=\n" + table
        (folder / f"{name}.mbsdf").write_bytes(content)


def _made(known: MeasuredFormat, folder: Path) -> list[Path]:
    ending = known.endings[0]
    if known.name in _TEXTS:
        for name, text in _TEXTS[known.name].items():
            (folder / name).write_text(text)
    elif known.name == "rgl":
        _write_rgl(folder / "small.bsdf")
    elif known.name == "pbsdf":
        _write_polarized(folder / "gold.pbsdf")
    elif known.name == "mbsdf":
        _write_mbsdf(folder)
    elif known.name == "merl":
        write_measured(
            IsotropicTable.from_reflectance(Lambertian(0.5), HalfAngleGrid(20, 20, 40)),
            folder / "small.binary",
        )
    elif known.name == "utia":
        np.random.default_rng(2).uniform(0.01, 0.2, (3, 288, 288)).astype("<f8").tofile(folder / "cloth.bin")
    elif known.name == "brdftable":
        table = IsotropicTable.from_reflectance(Lambertian(0.5), HalfAngleGrid(6, 6, 12))
        maps = np.random.default_rng(5).random((2, 8, 8, 3)).astype(np.float32)
        for name, value in {
            "isotropic": table,
            "scattered": _samples(),
            "spectra": _samples(5),
            "factored": Factored(maps[0], maps[1], (0.5, 0.6, 0.7)),
        }.items():
            write_measured(value, folder / f"{name}{ending}")
    elif known.write is not None:
        for name, value in {"colours": _samples(), "spectra": _samples(5)}.items():
            with contextlib.suppress(FileError):  # a format may hold spectra alone
                known.write(value, folder / f"{name}{ending}")
    return sorted(folder.iterdir())


def reader_of(known: MeasuredFormat) -> Reader:
    """Return the reader of a format: by the registry and by the format; values are finite and not negative."""

    def read(path: Path) -> None:
        for value in (known.read(path, ReadOptions()), read_measured(path)):
            found = value.eval(*_directions())
            if not np.isfinite(found).all() or (found < 0.0).any():
                raise WrongValueError("values that are no reflectance")

    return Reader(f"measured:{known.name}", read, lambda folder: _made(known, folder), has_place=True)


READERS = [reader_of(known) for known in FORMATS]
