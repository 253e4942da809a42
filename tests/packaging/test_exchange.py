"""Pictures of exports in their programs: how they are compared, and what an interrupted measurement leaves."""

from __future__ import annotations

import importlib
import importlib.util
import json
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError
from brdf_suite.files.exports.coated_facets_fit import fit_coated_facets
from brdf_suite.files.exports.format import ExportItem
from brdf_suite.files.exports.usd_preview import loss_in_blender, losses
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.reports.handover import item_of


@pytest.fixture
def tool(checkout: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> ModuleType:
    pytest.importorskip("mitsuba")
    monkeypatch.syspath_prepend(str(checkout / "packaging" / "pictures"))
    found = importlib.import_module("exchange")
    monkeypatch.setattr(found, "FIGURES", tmp_path / "exchange.json")
    return found


def disc(tool: ModuleType, light: tuple[float, float, float] = (0.2, 0.1, 0.05)) -> Floats:
    """Return a picture (h, w, 4) of a disc where the sphere is, even light by even coverage."""
    fine = (np.arange(8 * tool.SIZE) + 0.5) / 8.0 - 0.5 * tool.SIZE
    radius = tool.RADIUS / tool.WIDTH * tool.SIZE / np.sqrt(1.0 - (tool.RADIUS / tool.DISTANCE) ** 2)
    inside = (np.hypot(fine, fine[:, None]) < radius).reshape(tool.SIZE, 8, tool.SIZE, 8)
    coverage = inside.mean(axis=(1, 3))[..., None]
    return np.concatenate((coverage * light, coverage), axis=-1)


def test_a_picture_a_row_off_is_refused(tool: ModuleType) -> None:
    picture = disc(tool)
    tool.check_place("luxcore", picture, picture)
    with pytest.raises(ValueRangeError, match="the sphere of luxcore is"):
        tool.check_place("luxcore", picture, np.roll(picture, 1, axis=0))


def test_the_rim_counts_by_what_is_covered(tool: ModuleType) -> None:
    picture = disc(tool)
    assert tool.difference(picture, picture)[0] == 0.0
    # A program without anti-aliasing covers pixels wholly or not at all; the light is the same.
    hard = np.concatenate(
        (np.broadcast_to((0.2, 0.1, 0.05), (*picture.shape[:2], 3)), np.ones((96, 96, 1))), -1
    )
    hard = hard * (picture[..., 3:] > 0.5)
    assert tool.difference(picture, hard)[0] == pytest.approx(0.0, abs=1e-6)
    rim = picture * np.where((picture[..., 3:] > 0.0) & (picture[..., 3:] < 0.999), (2.0, 2.0, 2.0, 1.0), 1.0)
    assert 0.2 < tool.difference(picture, rim)[0] < tool.difference(picture, disc(tool, (0.4, 0.2, 0.1)))[0]


def test_colours_outside_rec_709_count(tool: ModuleType) -> None:
    outside, edge = disc(tool, (0.3, -0.01, 0.02)), disc(tool, (0.3, 0.0, 0.02))
    assert tool.difference(outside, edge)[0] > 0.5


def test_an_interrupted_measurement_leaves_gaps_that_are_filled(
    tool: ModuleType, capsys: pytest.CaptureFixture[str]
) -> None:
    row = {"reported": 1.0, "seen": 1.1}
    paints, clients = tool.in_order(["blue", *reversed(tool.PICTURED)]), list(tool.CLIENTS)
    assert paints == [*tool.PICTURED, "blue"]
    tool.write_figures({name: dict.fromkeys(clients, row) for name in (*paints, "copper")})
    assert tool.gaps(paints, clients) == {}
    tool.remove_figures(paints, ["rgl"])
    assert tool.read_figures()["copper"] == dict.fromkeys(clients, row)
    assert tool.gaps(["blue"], clients) == {"blue": ["rgl"]}
    tool.remove_figures(paints, clients)
    assert json.loads(tool.FIGURES.read_text()) == {"copper": dict.fromkeys(clients, row)}
    # Those of the picture are one run: a part of them is measured again.
    tool.write_figures({name: dict.fromkeys(clients, row) for name in tool.PICTURED[:3]})
    capsys.readouterr()
    assert tool.gaps(paints, clients) == dict.fromkeys(paints, clients)
    assert capsys.readouterr().out == ""
    tool.write_figures({name: dict.fromkeys(clients, row) for name in tool.PICTURED})
    assert tool.gaps(paints, clients) == {"blue": clients}
    assert "pearl, luxcore: in the file, reported 1.00, seen 1.10\n" in capsys.readouterr().out


def test_luxcore_draws_the_sphere_where_the_others_do(
    tool: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if importlib.util.find_spec("pyluxcore") is None:
        pytest.skip("could not import pyluxcore")
    monkeypatch.setattr(tool, "SAMPLES", {"luxcore": 16})
    tool.start()
    light = np.ones((16, 32, 3))
    studio = tool.Studio(light, light, tmp_path / "light.exr", tmp_path, None)
    tool.mi.Bitmap(light.astype(np.float32)).write(str(studio.light_file))
    picture, _ = tool.carpaint_in_luxcore(ExportItem(load_shipped_paint("solid_white")), studio)
    tool.check_place("luxcore", disc(tool), picture)
    assert picture[0, 0].tolist() == [0.0, 0.0, 0.0, 0.0]


def test_what_is_seen_is_what_is_reported(checkout: Path) -> None:
    figures = json.loads((checkout / "docs" / "method" / "exchange.json").read_text(encoding="utf-8"))
    assert len(figures) == 40
    for name, clients in figures.items():
        assert set(clients) == {"blender", "luxcore", "usd", "openpbr", "rgl"}, name
        for client, found in clients.items():
            near = max(0.5, 0.2 * found["reported"])
            assert abs(found["seen"] - found["reported"]) <= near, (name, client)


BOUNDS = {
    "blender": {"solid": 2.0, "metallic": 3.0, "pearl": 3.0},
    "luxcore": {"solid": 2.0, "metallic": 4.0, "pearl": 4.0},
}
"""Mean ΔE00 of a rendered sphere that the exports may be off, by class."""


@pytest.mark.parametrize("client", BOUNDS)
def test_the_means_of_classes_are_within_their_bounds(
    checkout: Path, monkeypatch: pytest.MonkeyPatch, client: str
) -> None:
    monkeypatch.syspath_prepend(str(checkout / "packaging" / "documents"))
    tables = importlib.import_module("insert_figures")
    seen: dict[str, list[float]] = {}
    for name, clients in tables.exchange_figures().items():
        seen.setdefault(tables.paint_class(name), []).append(clients[client]["seen"])
    assert seen.keys() == BOUNDS[client].keys()
    means = {kind: float(np.mean(found)) for kind, found in seen.items()}
    assert {kind: mean for kind, mean in means.items() if mean > BOUNDS[client][kind]} == {}


def test_usd_states_what_blender_shows_besides() -> None:
    item = item_of("midnight_blue")
    there, elsewhere = loss_in_blender(item), fit_coated_facets(item, "usd").on_sphere
    assert there > elsewhere + 0.4
    assert f"In Blender, which evaluates the clearcoat otherwise, ΔE00 {there:.1f} on a sphere." in losses(
        item
    )
