"""A few hundred damaged copies of each real file; ``tools/attack/fuzz_measured.py`` makes ten thousand."""

from __future__ import annotations

import importlib.util
import json
import struct
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint
from brdf_suite.documents.store import paint_to_json
from brdf_suite.files.measured import read_measured, write_measured
from brdf_suite.files.measured.rgl import pack
from brdf_suite.reflectance.factored.model import Factored
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

pytest.importorskip("resource", reason="memory limits are set through the Unix module resource")
if not Path("/proc/self/statm").exists():
    pytest.skip("the memory in use is read from /proc", allow_module_level=True)

MUTATIONS = 150
LINES = 400


@pytest.fixture(scope="module")
def fuzzing(checkout: Path) -> ModuleType:
    path = checkout / "tools" / "attack" / "fuzz_measured.py"
    spec = importlib.util.spec_from_file_location("fuzz_measured", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    module.SECONDS = 60.0  # a busy machine is no fault of a reader
    return module


@pytest.mark.parametrize(
    "name",
    [
        "bird_example.json",
        "cayman.brdf",
        "krylon_blue.brdf",
        "paper_white_rgb.bsdf",
        "retro-gray-tape.dat",
        "vch_golden_yellow_rgb.bsdf",
    ],
)
def test_damaged_files_are_refused_or_read_within_the_limits(
    shared_data: Path, tmp_path: Path, fuzzing: ModuleType, name: str
) -> None:
    path = tmp_path / name
    content = (shared_data / "brdf" / name).read_bytes()
    if path.suffix in (".brdf", ".dat"):  # thousands of lines that are read one like the other
        content = b"".join(content.splitlines(keepends=True)[:LINES])
    path.write_bytes(content)
    counts, longest = fuzzing.fuzz(path, MUTATIONS, seed=7, keep=tmp_path / "faults")
    assert not [result for result in counts if result.startswith("FAULT")]
    assert counts["read"] > 0  # some damage does no harm, so the readers were really reached
    assert counts["refused"] > MUTATIONS // 2
    assert longest < fuzzing.SECONDS


SMALL = {
    "chip.astm": "NUM_POINTS 2\nVARS theta_i,phi_i,theta_s,phi_s,465nm,525nm,630nm\n"
    "0.1,0,0.2,3.0,0.5,0.25,0.125\n0.3,0,0.4,1.0,1,1,1\n",
    "panel.bsdf": "Source Measured\nSymmetry PlaneSymmetrical\nSpectralContent XYZ\nScatterType BRDF\n"
    "SampleRotation 1\n0\nAngleOfIncidence 2\n0 30\nScatterAzimuth 2\n0 180\nScatterRadial 3\n0 20 80\n"
    + "".join(
        f"Tristimulus{axis}\nDataBegin\nTIS 0.5\n9 2 0.1\n9 2 0.1\nTIS 0.5\n8 2 0.1\n8 1 0\nDataEnd\n"
        for axis in "XYZ"
    ),
    "foil.dat": "#format: theta phi DSF\n#intheta 30\n#inphi 0\n60 180 0.5\n30 180 4.0\n150 0 9\n",
    "pair.alta": "#DIM 6 3\n#PARAM_IN CARTESIAN\n#PARAM_OUT RGB_COLOR\n0 0 1 0.6 0 0.8 1.0 0.5 0.2\n",
    "retro.alta": "#DIM 3 1\n#VS 0\n#PARAM_IN RETRO_TL_TVL_PROJ_DPHI\n0.2 0.3 0.1 1.0\n0.7 0.5 0.2 0.5\n",
    "panel.ssdd": "VERSION 0.2\nDATA_TYPE brdf\nCOLOR_MODEL xyz\nPARAM_TYPE specular_coordinate_system\n"
    "REDUCTION_TYPE bilateral_symmetry\nPARAM0_LIST 0 45\nPARAM2_LIST 0 60\nPARAM3_LIST 0 180\nDATA ascii\n"
    + "0.3 0.3 0.2\n" * 8
    + "DATA_TYPE specular_reflectance\nCOLOR_MODEL monochrome\nPARAM0_LIST 0\nDATA ascii\n0.05\n",
    "half.ssdd": "VERSION 0.2\nDATA_TYPE brdf\nCOLOR_MODEL spectrum\nWAVELENGTH_LIST 450 550 650\n"
    "PARAM_TYPE half_difference_coordinate_system\nREDUCTION_TYPE bilateral_symmetry reciprocity\nPARAM0_LIST 0 9\n"
    "PARAM2_LIST 0 60\nPARAM3_LIST 0 90\nDATA binary\n" + "aaa>" * 24,
    "light.bsdf": "Symmetry Asymmetric\nSpectralContent XYZ\nScatterAzimuth 3\n0 90 270\nScatterRadial 2\n0 60\n"
    "DataBegin\n"
    + "".join(
        f"AOI {aoi}\nPOI 0\nSide Front\nTristimulusValue Tris{axis}\nScatterType BRDF\nTIS 0.5\n1 2 3 4 5 6\n"
        for aoi in (0, 45)
        for axis in "XYZ"
    )
    + "DataEnd\n",
    "coat.mtlx": '<?xml version="1.0"?><materialx version="1.39" colorspace="acescg"><nodegraph name="g"><constant'
    ' name="c" type="color3"><input name="value" type="color3" value="0.1 0.2 0.3"/></constant><output name="out"'
    ' type="color3" nodename="c"/></nodegraph><open_pbr_surface name="s" type="surfaceshader"><input name="base_color"'
    ' type="color3" nodegraph="g"/><input name="coat_weight" type="float" value="1"/><input name="coat_roughness"'
    ' type="float" value="0.3"/></open_pbr_surface><surfacematerial name="m" type="material"><input'
    ' name="surfaceshader" type="surfaceshader" nodename="s"/></surfacematerial></materialx>',
    "half.alta": "#DIM 4 1\n#VS 1\n#PARAM_IN RUSIN_TH_PH_TD_PD\n0.2 0.3 0.4 1.5 1.0 0.1\n0.2 0.3 0.5 1.5 1.0 0.1\n",
    "lobes.brdfpaint": json.dumps(
        paint_to_json(
            CookTorrancePaint("L", (0.1, 0.05, 0.02), (CookTorranceLobe((0.2, 0.3, 0.4), 0.3, 0.05),))
        )
    ),
}


@pytest.mark.parametrize("name", SMALL)
def test_formats_without_a_real_file_at_hand(tmp_path: Path, fuzzing: ModuleType, name: str) -> None:
    path = tmp_path / name
    path.write_text(SMALL[name])
    counts, longest = fuzzing.fuzz(path, MUTATIONS, seed=3)
    assert not [result for result in counts if result.startswith("FAULT")]
    assert counts["read"] > 0
    assert longest < fuzzing.SECONDS


@pytest.fixture(scope="module")
def tables(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a table of each layout, small or of the one size that the format knows."""
    folder = tmp_path_factory.mktemp("tables")
    matt = Lambertian(0.5)
    shape = (9, 8, 7, 2)
    mueller = {
        "theta_h": np.linspace(0.0, 1.5, 7, dtype=np.float32)[None],
        "theta_d": np.linspace(0.0, 1.5, 8, dtype=np.float32)[None],
        "phi_d": np.linspace(0.0, 6.28, 9, dtype=np.float32)[None],
        "wvls": np.array([500, 600], np.uint16),
        "M": np.full((*shape, 4, 4), 0.2, np.float32),
    }
    (folder / "gold.pbsdf").write_bytes(pack(mueller))
    head = b'NVIDIA ARC MBSDF V1\nname="x"\nMBSDF_DATA=\n' + struct.pack("<3I", 1, 4, 6)
    (folder / "paper.mbsdf").write_bytes(head + np.full((4, 4, 6, 3), 0.3, "<f4").tobytes())
    half = struct.pack("<3i", 12, 12, 24) + np.full((3, 12, 12, 24), 0.25, "<f2").tobytes()
    (folder / "half.binary").write_bytes(half)
    lines = b"#DIM 3 3\n#VS 0\n#PARAM_IN STARK_3D\n#PARAM_OUT RGB_COLOR\n#FORMAT binary\n#VERSION 0\n#ENDIAN little\n"
    rows = np.tile([0.2, 0.3, 1.0, 0.5, 0.4, 0.3], (20, 1)).astype("<f8").tobytes()
    (folder / "stark.alta").write_bytes(
        lines + b"#SAMPLE_COUNT 20\n#BEGIN_STREAM\n" + rows + b"\n#END_STREAM\n"
    )
    write_measured(
        IsotropicTable.from_reflectance(matt, HalfAngleGrid(6, 6, 12)), folder / "isotropic.brdftable"
    )
    write_measured(IsotropicTable.from_reflectance(matt, HalfAngleGrid(20, 20, 40)), folder / "small.binary")
    rng = np.random.default_rng(4)
    directions = rng.normal(size=(2, 40, 3))
    directions[..., 2] = np.abs(directions[..., 2]) + 0.1
    directions /= np.linalg.norm(directions, axis=-1, keepdims=True)
    write_measured(
        ScatteredSamples(directions[0], directions[1], rng.random((40, 3))), folder / "scattered.brdftable"
    )
    maps = rng.random((2, 8, 8, 3)).astype(np.float32)
    write_measured(Factored(maps[0], maps[1], (0.5, 0.6, 0.7)), folder / "factored.brdftable")
    rng.uniform(0.01, 0.2, (3, 288, 288)).astype("<f8").tofile(folder / "cloth.bin")
    write_measured(read_measured(folder / "cloth.bin"), folder / "anisotropic.brdftable")
    return folder


@pytest.mark.parametrize(
    "name",
    [
        "isotropic.brdftable",
        "scattered.brdftable",
        "anisotropic.brdftable",
        "factored.brdftable",
        "small.binary",
        "half.binary",
        "cloth.bin",
        "gold.pbsdf",
        "paper.mbsdf",
        "stark.alta",
    ],
)
def test_damaged_tables(tables: Path, tmp_path: Path, fuzzing: ModuleType, name: str) -> None:
    counts, longest = fuzzing.fuzz(tables / name, MUTATIONS, seed=5, keep=tmp_path)
    assert not [result for result in counts if result.startswith("FAULT")]
    # Past the checksum, too: without a right one next to nothing of our own tables would be read.
    assert counts["read"] > MUTATIONS // 10
    assert counts["refused"] > 0
    assert longest < fuzzing.SECONDS


def test_the_limits_bite(fuzzing: ModuleType, tmp_path: Path) -> None:
    from brdf_suite.files.measured.format import MeasuredFormat

    path = tmp_path / "any"
    path.write_bytes(b"x")

    def greedy(_path: object, _options: object) -> object:
        return bytearray(400 << 20)

    def endless(_path: object, _options: object) -> object:
        while True:
            pass

    before = fuzzing.SECONDS
    try:
        # Time enough for the first: on a busy machine a short one may be over before the memory is asked for.
        for read, word, fuzzing.SECONDS in ((greedy, "memory", before), (endless, "over", 0.1)):
            known = MeasuredFormat("x", "x", (".x",), lambda _head, _size: True, read)
            assert word in fuzzing.outcome(path, known)
    finally:
        fuzzing.SECONDS = before
