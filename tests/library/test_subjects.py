"""Names, files and values in memory are the same to every function; wrong ones get an error that says what to do."""

from __future__ import annotations

import typing
from pathlib import Path

import numpy as np
import pytest

import brdf_suite as bs
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.errors import FileError, ValueRangeError

MIRROR = bs.spherical([0.3, 0.8], 0.0), bs.spherical([0.5, 0.2], 3.0)


class Grey:
    """A reflectance that is no class of the suite."""

    def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        above = (wi[..., 2:] > 0.0) & (wo[..., 2:] > 0.0)
        return np.where(above, 0.5 / np.pi, 0.0) * np.ones(3)


def test_a_name_a_file_a_document_and_a_material_are_measured_alike(tmp_path: Path) -> None:
    paint = bs.load("blue", bs.Paint)
    bs.save(paint, tmp_path / "blue.brdfpaint")
    wanted = bs.measure("blue").lab
    subjects = (tmp_path / "blue.brdfpaint", paint, bs.load("blue"), bs.Entry(paint))
    for subject in subjects:
        np.testing.assert_array_equal(bs.measure(subject).lab, wanted)


def test_anything_with_eval_is_measured_checked_fitted_and_plotted() -> None:
    assert bs.measure(Grey()).readings[0].factor == pytest.approx(0.5, rel=1e-3)
    assert bs.check(Grey()).findings
    fitted = bs.fit(Grey())
    np.testing.assert_allclose(fitted.eval(*MIRROR), 0.5 / np.pi, rtol=0.02)
    assert bs.plot(Grey()).svg.startswith("<svg")


def test_a_fit_stands_for_what_was_fitted() -> None:
    fitted = bs.fit("blue")
    given, found = bs.measure("blue").lab, bs.measure(fitted).lab
    assert 0.0 < bs.delta_e(given[2:], found[2:]).max() < 2.0
    product = bs.factorize("fine_silver", resolution=16, pairs=2000)
    np.testing.assert_array_equal(product.eval(*MIRROR), product.value.eval(*MIRROR))
    assert bs.compare("fine_silver", product).differences["2000"]


def test_samples_in_arrays_are_what_a_file_of_samples_is() -> None:
    rng = np.random.default_rng(0)
    wi, wo = bs.spherical(np.arccos(rng.uniform(0.2, 1.0, (2, 300))), rng.uniform(0.0, 6.0, (2, 300)))
    values = bs.load("fine_silver", bs.Material).eval(wi, wo)
    both = bs.factorize(wi, wo, values, resolution=8), bs.factorize(bs.samples(wi, wo, values), resolution=8)
    np.testing.assert_array_equal(both[0].eval(wi, wo), both[1].eval(wi, wo))
    np.testing.assert_allclose(bs.samples(wi, wo, values).eval(wi, wo), values, rtol=1e-6)
    np.testing.assert_allclose(bs.samples(wi, wo, values[:, 0]).eval(wi, wo)[:, 2], values[:, 0], rtol=1e-6)
    with pytest.raises(ValueRangeError, match=r"values: has the shape \(299, 3\)"):
        bs.factorize(wi, wo, values[1:])
    with pytest.raises(ValueRangeError, match="all of wi, wo and values"):
        bs.factorize(wi, wo)  # type: ignore[call-overload]


@pytest.mark.parametrize(
    ("wi", "reason"),
    [
        ([0.0, 0.0, 2.0], r"wi: expected a direction of length 1, not 2; divide by np.linalg.norm\(wi"),
        ([[0.0, 0.0, 1.0], [0.0, 0.0, 0.5]], r"wi\[1\]: expected a direction of length 1, not 0.5"),
        ([0.0, np.nan, 1.0], "wi: expected a direction of length 1, not nan"),
        ([0.0, 1.0], r"wi: expected directions of the shape \(..., 3\), not \(2,\)"),
        (1.0, r"wi: expected directions of the shape \(..., 3\), not \(\)"),
        (np.tile([0.0, 0.0, 1.0], (3, 1)), "do not broadcast"),
    ],
)
def test_directions_that_are_none_are_refused_with_their_place(wi: object, reason: str) -> None:
    with pytest.raises(ValueRangeError, match=reason):
        bs.load("blue", bs.Material).eval(wi, MIRROR[1])  # type: ignore[arg-type]


def test_a_material_evaluates_as_its_reflectance_does() -> None:
    blue = bs.load("blue", bs.Material)
    np.testing.assert_array_equal(blue.eval(*MIRROR), blue.reflectance.eval(*MIRROR))
    assert blue.eval(MIRROR[0][:, None], MIRROR[1]).shape == (2, 2, 3)


def test_a_palette_is_loaded_as_one_and_its_entries_by_number(tmp_path: Path) -> None:
    paints = tuple(bs.Entry(bs.load(name, bs.Paint)) for name in ("blue", "fine_silver"))
    file = tmp_path / "two.cxf"
    bs.save(bs.Palette("Two", paints), file)
    found = bs.load(file)
    assert isinstance(found, bs.Palette)
    assert [entry.name for entry in found] == ["Blue", paints[1].name]
    one = bs.load(f"{file}#{found.entries[1].id}", bs.Material)
    assert one.name == paints[1].name
    near = bs.find_nearest("fine_silver", file, count=1)[0]
    assert near.entry.name == paints[1].name
    assert near.delta_e < 0.01
    with pytest.raises(FileError, match="is a palette of 2 paints; name one of them"):
        bs.load(file, bs.Material)
    with pytest.raises(bs.SuiteError, match=r"give one of its entries"):
        bs.measure(found)  # type: ignore[arg-type]


def test_what_is_of_another_kind_says_how_to_load_it() -> None:
    with pytest.raises(bs.SuiteError, match=r'load\("booth", brdf_suite.Environment\)'):
        bs.load("booth")
    with pytest.raises(FileError, match="load it as a Material"):
        bs.load("ggx" if "ggx" in bs.names("models") else bs.names("models")[0], bs.Paint)
    with pytest.raises(bs.SuiteError, match="expected Material, Palette, Paint, Environment or View"):
        bs.load("blue", dict)  # type: ignore[type-var]
    with pytest.raises(bs.SuiteError, match="Nothing that reflects: int"):
        bs.fit(3)  # type: ignore[arg-type]
    with pytest.raises(ValueRangeError, match="expected one of paints"):
        bs.names("paint")  # type: ignore[arg-type]


def test_every_shipped_name_of_a_subject_loads() -> None:
    for name in (*bs.names("table 1")[:2], *bs.names("models")):
        assert isinstance(bs.load(name), bs.Material)
    assert {"environments", "surfaces", "geometries", "formats"} <= {
        kind for kind in ("environments", "surfaces", "geometries", "formats") if bs.names(kind)
    }


@pytest.mark.parametrize("ending", [".brdfpaint", ".brdftable"])
def test_factors_are_saved_and_loaded(ending: str, tmp_path: Path) -> None:
    product = bs.factorize("fine_silver", resolution=8, pairs=1000)
    bs.save(product, tmp_path / f"factors{ending}")
    again = bs.load(tmp_path / f"factors{ending}", bs.Material)
    np.testing.assert_allclose(again.eval(*MIRROR), product.eval(*MIRROR), rtol=1e-3)


def test_views_and_environments_are_saved_and_loaded(tmp_path: Path) -> None:
    view = bs.View(environment="booth", exposure_ev=1.5)
    bs.save(view, tmp_path / "a.brdfview")
    assert bs.load(tmp_path / "a.brdfview", bs.View) == view
    sky = bs.Environment("sky", np.linspace(0.0, 2.0, 8 * 16 * 3, dtype=np.float32).reshape(8, 16, 3))
    bs.save(sky, tmp_path / "sky.exr")
    np.testing.assert_allclose(
        bs.load(tmp_path / "sky.exr", bs.Environment).radiance, sky.radiance, atol=1e-5
    )
    with pytest.raises(FileError, match=r"goes into an \.exr"):
        bs.save(sky, tmp_path / "sky.png")
    with pytest.raises(FileError, match="is no paint"):
        bs.save(bs.fit("blue"), tmp_path / "lobes.brdfpaint")


def test_exports_take_one_several_and_palettes(tmp_path: Path) -> None:
    palette = bs.Palette("Two", tuple(bs.Entry(bs.load(name, bs.Paint)) for name in ("blue", "fine_silver")))
    assert bs.export(palette, tmp_path / "a.csv").paints == 2
    assert bs.export(["blue", bs.load("fine_silver")], tmp_path / "b.cxf").paints == 2
    assert bs.export(bs.fit("blue"), tmp_path / "c.dat", format="csv").format == "csv"
    with pytest.raises(FileError, match="names no format"):
        bs.export("blue", tmp_path / "d.xyz")


def test_conversion_chooses_measured_data_or_palettes_by_the_ending(tmp_path: Path) -> None:
    bs.convert("blue", tmp_path / "one.cxf")
    done = bs.convert(tmp_path / "one.cxf", tmp_path / "one.gpl")
    assert done.format == "gpl"
    assert done.notes
    with pytest.raises(FileError, match="is no palette and no paint"):
        bs.convert(bs.names("models")[0], tmp_path / "model.gpl")


def test_a_picture_of_a_fit_is_that_of_its_material(tmp_path: Path) -> None:
    size = (48, 36)
    scene = {"size": size, "environment": "overcast"}
    by_name = bs.render("blue", **scene)
    of_fit = bs.render(bs.fit("blue"), tmp_path / "fit.png", **scene)
    assert of_fit.path == tmp_path / "fit.png"
    assert of_fit.path.read_bytes() == of_fit.content
    np.testing.assert_array_equal(np.asarray(of_fit), by_name.pixels)
    assert by_name.pixels.shape == (36, 48, 3)
    assert by_name._repr_png_() == by_name.content
    brighter = bs.render("blue", exposure_ev=1.0, **scene)
    assert brighter.pixels.mean() > by_name.pixels.mean()
    light = bs.render("blue", tmp_path / "light.exr", **scene)
    assert light.pixels.dtype == np.float32
    assert light._repr_png_() is None
    by_name.save(tmp_path / "again.png")
    assert (tmp_path / "again.png").read_bytes() == by_name.content
    with pytest.raises(FileError, match=r"ends in \.png"):
        by_name.save(tmp_path / "again.jpg")


@pytest.mark.parametrize("renderer", ["realtime", "raytraced"])
def test_an_environment_in_memory_lights_a_picture_as_its_file_does(
    renderer: typing.Literal["realtime", "raytraced"], tmp_path: Path
) -> None:
    scene = {"size": (32, 24), "surface": "sphere", "renderer": renderer}
    scene |= {} if renderer == "realtime" else {"samples": 2}
    light = bs.load("overcast", bs.Environment)
    named = bs.render("solid_red", environment="overcast", **scene).pixels.astype(int)
    given = bs.render("solid_red", environment=light, **scene).pixels
    assert np.abs(given - named).max() <= 1  # maps that were shipped are half floats of the same light
    twice = bs.render("solid_red", environment=2.0 * light.radiance, **scene)
    assert twice.pixels.mean() > 1.1 * given.mean()


def test_a_picture_in_a_light_of_ones_own_says_so(tmp_path: Path) -> None:
    mine = bs.Environment("my light, 2", np.full((32, 64, 3), 0.5))
    picture = bs.render("solid_red", tmp_path / "a.png", size=(32, 24), surface="sphere", environment=mine)
    assert picture.path is not None
    assert b'"environment":"my_light_2"' in picture.content
    for wrong in (np.full((32, 64, 3), -1.0), np.full((32, 64, 3), np.nan), np.ones((32, 64))):
        with pytest.raises(ValueRangeError, match="radiance"):
            bs.render("solid_red", size=(32, 24), environment=wrong)


def test_texture_is_read_with_the_colours() -> None:
    blue, red = bs.measure("blue").texture, bs.measure("solid_red").texture
    assert blue is not None
    assert red is not None
    assert [one.light_deg for one in blue.sparkle] == [15.0, 45.0, 75.0]
    assert min(one.grade for one in blue.sparkle) > 0.0 == max(one.grade for one in red.sparkle)
    assert blue.graininess > 0.0 == red.graininess


def test_wrong_arguments_of_a_picture_are_named() -> None:
    with pytest.raises(ValueRangeError, match=r"size\[1\]: expected 1 to 65,536 pixels, not 0"):
        bs.render("blue", size=(10, 0))
    with pytest.raises(ValueRangeError, match="realtime, reference, raytraced"):
        bs.render("blue", renderer="fast")  # type: ignore[arg-type]
    with pytest.raises(FileError, match="environment"):
        bs.render("blue", environment="nowhere")
    with pytest.raises(FileError, match="surface"):
        bs.render("blue", surface="nothing")


def test_a_paint_a_fit_and_a_palette_have_drawings_for_notebooks() -> None:
    paint = bs.load("blue", bs.Paint)
    shown = paint._repr_html_()
    assert shown == bs.plot("blue").svg
    assert shown.count("<rect") > 90  # the strip's bands
    assert bs.load("blue", bs.Material)._repr_html_() == shown
    assert bs.fit("blue")._repr_html_().count("<polyline") > shown.count("<polyline")
    assert "2 entries" in bs.Palette("Two", (bs.Entry(paint), bs.Entry(paint)))._repr_html_()


def test_a_drawing_is_saved_as_it_is(tmp_path: Path) -> None:
    drawing = bs.plot(bs.fit_cook_torrance("table1_white", lobes=1, starts=1, samples=300))
    drawing.save(tmp_path / "fit.svg")
    assert (tmp_path / "fit.svg").read_text(encoding="utf-8") == drawing.svg
    with pytest.raises(FileError, match=r"ends in \.svg"):
        drawing.save(tmp_path / "fit.png")


def test_a_drawing_shows_what_is_not_seen_in_a_name() -> None:
    flat = FlatColour("Blue\u00ad<b>", "RGB", (0.0, 0.0, 1.0), space="sRGB")
    svg = bs.plot(bs.Palette("Two\u00ad", (bs.Entry(flat),))).svg
    assert "<title>Blue[U+00AD]&lt;b&gt;</title>" in svg
    assert 'aria-label="Two[U+00AD]: 1 entry"' in svg
    assert "\u00ad" not in svg
