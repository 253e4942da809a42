"""The document of a factored paint: its textures beside it, moved with it, and never taken for others."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.documents.factor_textures import read_textures, write_textures
from brdf_suite.documents.factored import FactoredPaint, TextureFile
from brdf_suite.documents.store import (
    any_paint_from_json,
    load_any_paint,
    load_paint,
    paint_to_json,
    save_paint,
)
from brdf_suite.errors import DocumentError, FileError, ValueRangeError

RNG = np.random.default_rng(7)
MAPS = {
    "p": RNG.random((8, 3)).astype(np.float32) + 0.1,
    "q": RNG.random((6, 6, 3)).astype(np.float32) + 0.1,
    "s": RNG.random((16, 3)).astype(np.float32) + 0.1,
}


def saved(folder: Path) -> FactoredPaint:
    """A paint that was saved into ``folder``, as it is loaded again."""
    path = folder / "satin.brdfpaint"
    textures = write_textures(MAPS, path)
    paint = FactoredPaint(
        "Satin", textures, "p:|wo| q:h p:|wi|", (0.1, 0.2, 0.3), peak="s:sqrt|h|", largest=4.0
    )
    save_paint(paint, path)
    loaded = load_any_paint(path)
    assert loaded == paint
    assert isinstance(loaded, FactoredPaint)
    return loaded


def test_the_maps_come_back_to_the_last_bit(tmp_path: Path) -> None:
    found = read_textures(saved(tmp_path))
    assert set(found) == set(MAPS)
    for name, values in MAPS.items():
        np.testing.assert_array_equal(found[name], values)
    text = json.loads((tmp_path / "satin.brdfpaint").read_text("utf-8"))
    assert text["kind"] == "factored"
    # From its own folder, so that both can be moved together.
    assert text["textures"]["path"] == f"satin-{text['textures']['sha256'][:16]}.exr"


def test_a_folder_may_be_moved_and_a_copy_takes_its_textures_along(tmp_path: Path) -> None:
    first, second = tmp_path / "first", tmp_path / "second"
    first.mkdir()
    paint = saved(first)
    second.mkdir()
    save_paint(replace(paint, name="Copy"), second / "copy.brdfpaint")
    first.rename(tmp_path / "moved")
    for path in (tmp_path / "moved" / "satin.brdfpaint", second / "copy.brdfpaint"):
        np.testing.assert_array_equal(read_textures(load_any_paint(path))["q"], MAPS["q"])


def test_a_message_to_another_program_names_the_textures_by_their_whole_path(tmp_path: Path) -> None:
    paint = saved(tmp_path)
    assert any_paint_from_json(json.loads(json.dumps(paint_to_json(paint)))) == paint


def test_other_textures_are_not_taken_for_those_that_were_meant(tmp_path: Path) -> None:
    paint = saved(tmp_path)
    file = Path(paint.textures.path)
    content = file.read_bytes()
    file.write_bytes(content[:-1] + bytes([content[-1] ^ 1]))
    # Windows begin a sentence with it, and would change the name of a file.
    with pytest.raises(DocumentError, match=rf": the maps in {re.escape(file.name)} are not those"):
        read_textures(paint)
    file.unlink()
    with pytest.raises(FileError, match=r"textures .* cannot be read"):
        read_textures(paint)


@pytest.mark.parametrize(
    ("words", "said"),
    [("p:|wo| q:h p:|wi| d:w.h", "lacks the map 'd'"), ("p:wo q:h p:wi", "does not read")],
)
def test_maps_that_the_words_do_not_fit_are_named(tmp_path: Path, words: str, said: str) -> None:
    with pytest.raises(DocumentError, match=said):
        read_textures(replace(saved(tmp_path), factors=words))


def test_a_map_that_holds_no_factor_is_refused(tmp_path: Path) -> None:
    bad = {**MAPS, "q": np.zeros((6, 6, 3), np.float32)}
    textures = write_textures(bad, tmp_path / "bad.brdfpaint")
    paint = FactoredPaint("Bad", textures, "p:|wo| q:h p:|wi|", (1.0, 1.0, 1.0))
    with pytest.raises(DocumentError, match="part q"):
        read_textures(paint)
    assert not read_textures(replace(paint, logarithmic=False))["q"].any()


def test_a_file_of_that_hash_that_is_no_picture_is_refused(tmp_path: Path) -> None:
    import hashlib

    file = tmp_path / "maps.exr"
    file.write_bytes(b"no picture")
    textures = TextureFile(str(file), hashlib.sha256(b"no picture").hexdigest())
    with pytest.raises(FileError, match="holds no maps"):
        read_textures(FactoredPaint("Bad", textures, "p:wi", (1.0, 1.0, 1.0)))


@pytest.mark.parametrize(
    ("change", "place"),
    [
        ({"factors": "p:somewhere"}, "factors"),
        ({"peak": "s"}, "peak"),
        ({"alpha": (1.0, -1.0, 1.0)}, "alpha[1]"),
        ({"logarithmic": "yes"}, "logarithmic"),
        ({"largest": float("nan")}, "largest"),
        ({"textures": None}, "textures"),
    ],
)
def test_a_bad_field_is_named(change: dict, place: str) -> None:
    fields = {"textures": TextureFile("a.exr", "0" * 64), "factors": "p:wi", "alpha": (1.0, 1.0, 1.0)}
    with pytest.raises(ValueRangeError) as caught:
        FactoredPaint("x", **{**fields, **change})
    assert caught.value.place == place


def test_where_readings_are_wanted_a_factored_paint_is_refused_by_its_kind(tmp_path: Path) -> None:
    saved(tmp_path)
    with pytest.raises(DocumentError, match="factored paint"):
        load_paint(tmp_path / "satin.brdfpaint")
