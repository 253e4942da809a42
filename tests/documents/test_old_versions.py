"""Documents that released versions of the suite wrote open with the values that they had."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import old_documents as old
import pytest

from brdf_suite.acquisition.session.store import read_session
from brdf_suite.documents.factor_textures import read_textures
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.palette_store import load_palette
from brdf_suite.documents.project import load_project
from brdf_suite.documents.reading import VERSIONS
from brdf_suite.documents.store import load_any_paint, load_view
from brdf_suite.documents.studio import load_light
from brdf_suite.files.measured.brdftable import read_brdftable, write_brdftable
from brdf_suite.fitting.lobes.basis import read_basis

SAMPLES = Path(__file__).parent / "old" / "0.1.0"


def test_every_kind_of_document_has_a_sample() -> None:
    endings = {path.suffix.removeprefix(".") for path in SAMPLES.iterdir()}
    assert {name for name in VERSIONS if " " not in name} | {"brdftable"} <= endings
    assert (SAMPLES / "session.json").is_file()


@pytest.mark.parametrize("kind", ["aspecular", "cook_torrance"])
def test_paints(kind) -> None:
    assert load_any_paint(SAMPLES / f"{kind}.brdfpaint") == getattr(old, kind)()


def test_a_factored_paint_finds_its_maps() -> None:
    paint = load_any_paint(SAMPLES / "factored.brdfpaint")
    assert isinstance(paint, FactoredPaint)
    assert paint == old.factored(paint.textures)
    maps = read_textures(paint)
    assert maps.keys() == old.MAPS.keys()
    for name, values in old.MAPS.items():
        np.testing.assert_array_equal(maps[name], values)


def test_a_palette() -> None:
    assert load_palette(SAMPLES / "palette.brdfpalette") == old.palette()


def test_a_view() -> None:
    assert load_view(SAMPLES / "view.brdfview") == old.view()


@pytest.mark.parametrize("name", old.lights())
def test_lights(name) -> None:
    assert load_light(SAMPLES / f"{name}.brdfstudio") == old.lights()[name]


def test_a_session() -> None:
    assert read_session(SAMPLES) == old.session()


def test_a_basis() -> None:
    assert read_basis(SAMPLES / "basis.json").exponents == old.EXPONENTS


@pytest.mark.parametrize("kind", old.tables())
def test_tables(kind, tmp_path) -> None:
    """Written by today's code, what is read and what it should be are the same bytes: arrays, source and facts."""
    read = read_brdftable(SAMPLES / f"{kind}.brdftable")
    assert type(read) is type(old.tables()[kind])
    write_brdftable(read, tmp_path / "read")
    write_brdftable(old.tables()[kind], tmp_path / "wanted")
    assert (tmp_path / "read").read_bytes() == (tmp_path / "wanted").read_bytes()


def test_a_project_with_its_collected_file(tmp_path) -> None:
    read = load_project(SAMPLES / "project.brdfproject", tmp_path)
    source = Path(read.source)
    assert tmp_path in source.parents
    assert source.read_bytes() == (SAMPLES / "isotropic.brdftable").read_bytes()
    assert replace(read, source="") == replace(old.project(source), source="")
