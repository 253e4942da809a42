"""Picture files, turntables, videos and contact sheets, for real, small."""

from __future__ import annotations

import io
import json
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import OpenEXR
import pytest
from filelock import FileLock
from PIL import Image, ImageCms, ImageDraw

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING
from brdf_suite.documents.paint import Gloss, solid_paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.store import save_paint, view_from_json
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Lamp, Sparkle, SurfaceLook
from brdf_suite.errors import Cancelled, FileError, MissingExtraError, ValueRangeError
from brdf_suite.files.images.environments import write_exr
from brdf_suite.output import video
from brdf_suite.output.picture_file import PictureSettings
from brdf_suite.output.still import render_to_file
from brdf_suite.output.turning import turned
from brdf_suite.output.turntable import Turn, framed_all_round, write_turntable
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material, load_shipped_paint
from brdf_suite.pipeline.scene import find_environment
from brdf_suite.realtime.camera import Bounds, matrices
from brdf_suite.realtime.pictures.display import Display
from brdf_suite.realtime.pictures.tone_curves import to_display
from brdf_suite.reports import sheet_text
from brdf_suite.reports.contact_sheet.document import sheet_items, write_sheet
from brdf_suite.reports.contact_sheet.pictures import SheetItem, cell_text, item_pictures

VIEW = View(
    Camera(azimuth_deg=30.0, elevation_deg=15.0), surface="sphere", background="grey", sparkle=Sparkle("off")
)
SIZE = (64, 48)
WHITE = solid_paint("Weiß", (95.0, 0.0, 1.0))
BLUE = solid_paint("Blue", (30.0, 5.0, -40.0))


pytestmark = pytest.mark.usefixtures("shared_cache")


@pytest.fixture
def lit(shared_cache: Path) -> View:
    """:data:`VIEW` in the booth's light on an eighth of its texels: to load the whole takes longer than a picture."""
    path = shared_cache / "tests" / "small booth.exr"
    with FileLock(f"{shared_cache / 'small booth'}.lock"):
        if not path.exists():
            path.parent.mkdir(exist_ok=True)
            whole = read_environment(find_environment("booth")[1]).radiance
            write_exr(path, whole.reshape(64, 8, 128, 8, 3).mean(axis=(1, 3)))
    return replace(VIEW, environment=str(path))


def stop_at(fraction: float):
    def progress(done: float, _what: str) -> None:
        if done >= fraction:
            raise Cancelled

    return progress


def test_png_of_16_bits_in_display_p3_says_what_it_is(lit: View, tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    render_to_file("blue", replace(lit, clipping_marks=True), SIZE, path, PictureSettings(16, "display-p3"))
    assert path.read_bytes()[24] == 16
    with Image.open(path) as image:
        profile = ImageCms.ImageCmsProfile(io.BytesIO(image.info["icc_profile"]))
        assert ImageCms.getProfileDescription(profile).strip() == "Display P3"
        assert image.info["Title"] == "Blue"
        view = view_from_json(json.loads(image.info["View"]))
    # All that is in the picture is in the view: it can be drawn again.
    assert replace(view, camera=lit.camera) == replace(lit, clipping_marks=True)
    assert view.camera.distance is not None


def test_an_automatic_exposure_is_written_as_it_was_measured(lit: View, tmp_path: Path) -> None:
    view = replace(lit, exposure_mode="automatic", exposure_ev=0.0)
    render_to_file("blue", view, SIZE, tmp_path / "a.png", PictureSettings(samples=1))
    with Image.open(tmp_path / "a.png") as image:
        written = view_from_json(json.loads(image.info["View"]))
        words = image.info["Description"]
        codes = np.asarray(image)
    assert written.exposure_mode == "locked"
    assert abs(written.exposure_ev) > 0.1
    assert f"{written.exposure_ev:+g} EV" in words
    render_to_file("blue", written, SIZE, tmp_path / "b.png", PictureSettings(samples=1))
    with Image.open(tmp_path / "b.png") as image:
        assert (np.asarray(image) == codes).all()


def test_exr_is_radiance_whatever_the_exposure(lit: View, tmp_path: Path) -> None:
    """Its pixels through our tone curve are the PNG's."""
    pictures = {}
    for name, settings, ev in (
        ("a.exr", PictureSettings(samples=1), 0.0),
        ("b.exr", PictureSettings(16, samples=1), 3.0),
        ("c.exr", PictureSettings(32, "srgb", samples=1), 0.0),
        ("d.exr", PictureSettings(transparent=True), 0.0),
    ):
        render_to_file("blue", replace(lit, exposure_ev=ev), SIZE, tmp_path / name, settings)
        with OpenEXR.File(str(tmp_path / name)) as file:
            channels = file.channels()
            pictures[name] = {key: channel.pixels.astype(float) for key, channel in channels.items()}
            assert file.header()["paint"] == "Blue"
            red = file.header()["chromaticities"][:2]
            assert red == pytest.approx((0.64, 0.33) if name == "c.exr" else (0.708, 0.292))
    object_alone = pictures["d.exr"]["RGBA"]
    inside = object_alone[..., 3] == 1.0
    a, b, c = (pictures[name]["RGB"][inside] for name in ("a.exr", "b.exr", "c.exr"))
    np.testing.assert_allclose(b, a, rtol=3e-3, atol=1e-4)
    np.testing.assert_allclose(c @ REC709_TO_WORKING.T, a, rtol=1e-4, atol=1e-5)
    assert object_alone[~inside & (object_alone[..., 3] == 0.0)].max() == 0.0
    render_to_file("blue", lit, SIZE, tmp_path / "a.png", PictureSettings(samples=1))
    codes = np.asarray(Image.open(tmp_path / "a.png")).astype(int)[inside]
    assert np.abs(to_display(a).astype(int) - codes).max() <= 1


@pytest.mark.parametrize(
    ("name", "settings", "message"),
    [
        ("a.jpg", PictureSettings(), "PNG or EXR"),
        ("a.png", PictureSettings(32), "8 or 16 bits"),
        ("a.exr", PictureSettings(8), "16 or 32 bits"),
        ("a.png", PictureSettings(None, "rec2020"), "rec2020 is for EXR"),
        ("no/a.png", PictureSettings(), "folder does not exist"),
    ],
)
def test_what_no_file_holds_is_reported_before_anything_is_made(
    lit: View, tmp_path: Path, name: str, settings: PictureSettings, message: str
) -> None:
    with pytest.raises(FileError, match=message):
        render_to_file("blue", lit, SIZE, tmp_path / name, settings, progress=stop_at(0.0))
    for bad in ({"samples": 0}, {"colour_space": "cmyk"}):
        with pytest.raises(ValueRangeError, match=next(iter(bad))):
            PictureSettings(**bad)


def test_a_cancelled_picture_leaves_the_old_one(lit: View, tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    path.write_bytes(b"old")
    with pytest.raises(Cancelled):
        render_to_file("blue", lit, SIZE, path, progress=stop_at(0.85))
    assert path.read_bytes() == b"old"
    assert [file.name for file in tmp_path.iterdir()] == ["a.png"]


def test_without_embree_the_picture_is_drawn_without_occlusion(
    lit: View, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("embreex.mesh_construction", "embreex.rtcore_scene"):
        monkeypatch.setitem(sys.modules, name, None)  # as where the package has no wheel
    view = replace(lit, surface_look=SurfaceLook(scale=0.8))  # not one that is kept
    made = render_to_file("blue", view, SIZE, tmp_path / "a.png")
    assert made.path.exists()
    assert any("drawn without occlusion" in notice for notice in made.notices)


def test_a_turned_view_looks_at_the_object_from_the_other_side() -> None:
    """A full turn is the same view; half a turn puts the object's back where its front was, light and lamps too."""
    lamps = (Lamp("point", (1.0, 2.0, 3.0)), Lamp("directional", azimuth_deg=170.0))
    view = replace(VIEW, camera=Camera(30.0, 15.0, 2.0, (0.3, 0.1, 0.0)), rotation_deg=10.0, lamps=lamps)
    centre = (0.5, 0.0, -0.25)
    again = turned(turned(view, 300.0, centre), 60.0, centre)
    assert again.camera.azimuth_deg == pytest.approx(30.0)
    assert again.camera.target == pytest.approx(view.camera.target)
    assert again.lamps[0].position == pytest.approx(lamps[0].position)
    assert again.lamps[1].azimuth_deg == pytest.approx(170.0)
    assert again.rotation_deg == pytest.approx(10.0)
    # A point of the object, turned with it by hand, is where it was seen before.
    bounds = Bounds((-1.0, -1.0, -1.0), (2.0, 1.0, 0.5))
    point = np.array([0.9, 0.2, 0.4, 1.0])
    quarter = np.array(
        [centre[0] + (point[2] - centre[2]), point[1], centre[2] - (point[0] - centre[0]), 1.0]
    )
    seen = matrices(turned(view, 90.0, centre).camera, bounds, SIZE).world_to_clip @ point
    wanted = matrices(view.camera, bounds, SIZE).world_to_clip @ quarter
    np.testing.assert_allclose(seen[:2] / seen[3], wanted[:2] / wanted[3], atol=1e-9)


def test_a_turntables_camera_keeps_its_distance() -> None:
    bounds = Bounds((-2.0, 0.0, -0.5), (2.0, 1.0, 0.5))
    camera = framed_all_round(VIEW, bounds, SIZE).camera
    for degrees in range(0, 360, 15):
        clip = matrices(turned(replace(VIEW, camera=camera), degrees, bounds.centre).camera, bounds, SIZE)
        corners = np.c_[bounds.corners, np.ones(8)] @ clip.world_to_clip.T
        assert np.abs(corners[:, :2] / corners[:, 3:]).max() <= 1.0
    placed = replace(VIEW, camera=Camera(distance=3.0))
    assert framed_all_round(placed, bounds, SIZE).camera.distance == 3.0


def test_a_turntable_as_a_folder_of_pictures(tmp_path: Path) -> None:
    folder = tmp_path / "turn"
    made = write_turntable("blue", VIEW, SIZE, folder, Turn(4), PictureSettings(16, transparent=True))
    assert made.frames == 4
    files = sorted(file.name for file in folder.iterdir())
    assert files == [f"frame_{i:04d}.png" for i in range(1, 5)]
    frames = [np.asarray(Image.open(folder / name).convert("RGBA")).astype(int) for name in files]
    assert all(frame.shape == (48, 64, 4) for frame in frames)
    # A sphere stands still while it turns, and so does the light. (In the small one texels would be seen to change.)
    assert np.abs(frames[1] - frames[0]).max() <= 3
    with pytest.raises(FileError, match="not an empty folder"):
        write_turntable("blue", VIEW, SIZE, folder, Turn(2))
    assert sorted(file.name for file in folder.iterdir()) == files


def test_a_cancelled_turntable_leaves_nothing(lit: View, tmp_path: Path) -> None:
    for name in ("turn", "turn.mp4"):
        if name.endswith("mp4"):
            pytest.importorskip("imageio_ffmpeg")
        with pytest.raises(Cancelled):
            write_turntable("blue", lit, SIZE, tmp_path / name, Turn(8), progress=stop_at(0.5))
        assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("ending", [".mp4", ".webm"])
def test_a_video_plays_what_was_drawn(tmp_path: Path, ending: str) -> None:
    reader = pytest.importorskip("imageio_ffmpeg")
    path = tmp_path / f"a{ending}"
    patches = [
        np.full((48, 64, 3), colour, np.uint8) for colour in ((200, 60, 40), (30, 90, 180), (119, 119, 119))
    ]
    with video.writing_video(path, SIZE, 25.0, {"Title": "Blue"}) as feed:
        for patch in patches:
            for _ in range(5):
                feed(patch)
    command = [reader.get_ffmpeg_exe(), "-i", str(path), "-f", "rawvideo", "-pix_fmt", "rgb24", "-"]
    read = subprocess.run(command, capture_output=True, check=True)
    for words in (b"64x48", b"25 fps", b"bt709/bt709/iec61966-2-1"):
        assert words in read.stderr
    pixels = np.frombuffer(read.stdout, np.uint8).reshape(15, 48, 64, 3).astype(int)
    # BT.709 with 219 steps of luma: three codes are near.
    for index, patch in ((2, patches[0]), (7, patches[1]), (12, patches[2])):
        assert np.abs(pixels[index][8:40, 8:56] - patch[0, 0]).max() <= 4


def test_videos_that_cannot_be(lit: View, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("imageio_ffmpeg")
    path = tmp_path / "a.mp4"
    with pytest.raises(ValueRangeError, match="even width and height: 64x48, not 63x47"):
        write_turntable("blue", lit, (63, 47), path, Turn(2))
    with pytest.raises(FileError, match="8 bits in sRGB"):
        write_turntable("blue", lit, SIZE, path, Turn(2), PictureSettings(16))
    with pytest.raises(FileError, match="a name without ending"):
        write_turntable("blue", lit, SIZE, tmp_path / "a.gif", Turn(2))
    with pytest.raises(ValueRangeError, match="frames"):
        Turn(1)
    broken = tmp_path / "ffmpeg"
    broken.write_text("#!/bin/sh\necho 'no such codec' >&2\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setattr(video, "ffmpeg", lambda: str(broken))
    for size in (SIZE, (16, 16)):  # a small frame is still held when the pipe breaks
        with (
            pytest.raises(FileError, match="could not be made: no such codec"),
            video.writing_video(path, size, 25.0, {}) as feed,
        ):
            feed_black(feed, size)
    assert [file.name for file in tmp_path.iterdir()] == ["ffmpeg"]


def test_without_ffmpeg_the_error_says_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", None)
    with pytest.raises(
        MissingExtraError, match=r"needs ffmpeg.*, which is not installed; `.*video` installs it"
    ):
        video.ffmpeg()


def feed_black(feed, size: tuple[int, int]) -> None:
    for _ in range(1000):  # more than a pipe holds
        feed(np.zeros((size[1], size[0], 3), np.uint8))


def palette() -> Palette:
    impossible = solid_paint("Impossible", (20.0, 0.0, 0.0), Gloss(5.0, 95.0))
    blues = [Entry(paint, group=("Blues",)) for paint in (BLUE, impossible)]
    return Palette("Summer", (Entry(WHITE), *blues))


def test_a_sheet_of_a_palette(lit: View, tmp_path: Path) -> None:
    source, path = tmp_path / "a.brdfpalette", tmp_path / "sheet.png"
    save_palette(palette(), source)
    heard: list[str] = []
    made = write_sheet([source], lit, (80, 60), path, 2, progress=lambda _f, what: heard.append(what))
    assert made.paints == 3
    assert len(made.problems) == 1
    assert made.problems[0].startswith("Impossible:")
    assert any("Blue, 2 of 3" in what for what in heard)
    with Image.open(path) as image:
        assert image.size == (made.width, made.height) == (16 + 2 * 96, made.height)
        assert image.info["Title"] == "Summer"
        codes = np.asarray(image).astype(int)
    assert codes[2, 2].tolist() == [119, 119, 119]
    assert codes.min() == 0  # the title
    # White stands in the first line of cells, blue in the second, under its heading.
    coloured = codes[..., 2] - codes[..., 0] > 40
    bright = codes.min(axis=-1) > 180
    assert np.flatnonzero(bright.any(axis=1)).min() + 60 < np.flatnonzero(coloured.any(axis=1)).min()


def test_the_head_of_a_narrow_sheet_takes_the_lines_that_it_needs(lit: View, tmp_path: Path) -> None:
    source, path = tmp_path / "a.brdfpalette", tmp_path / "sheet.png"
    long = "What our customers asked for in the summer of this year and of the one before"
    save_palette(Palette(long, (Entry(WHITE),)), source)
    narrow = write_sheet([source], lit, (80, 60), path, 1)
    with Image.open(path) as image:
        rows = np.flatnonzero((np.asarray(image)[: narrow.height - 120] == 0).all(axis=2).any(axis=1))
    # Of the title and of the notices about the light there are more lines than two; gaps part them.
    assert 1 + np.count_nonzero(np.diff(rows) > 1) >= 6


def test_a_sheet_of_a_folder_leaves_out_what_a_killed_writer_left(tmp_path: Path) -> None:
    path = tmp_path / "white.brdfpaint"
    save_paint(WHITE, path)
    shutil.copy(path, tmp_path / ".white.0123456789abcdef.brdfpaint")
    _, items = sheet_items(tmp_path)
    assert [item.name for item in items] == [WHITE.name]
    path.unlink()
    with pytest.raises(FileError, match="holds no"):
        sheet_items(tmp_path)


def test_a_sheet_of_a_folder_reports_what_cannot_be_read(tmp_path: Path) -> None:
    for paint in (WHITE, BLUE):
        save_paint(paint, tmp_path / f"{paint.name}.brdfpaint")
    (tmp_path / "aa.brdfpaint").write_text("{}")
    title, items = sheet_items(tmp_path)
    assert title == tmp_path.name
    assert [(item.name, item.paint is None) for item in items] == [
        ("aa", True),
        ("Blue", False),
        ("Weiß", False),
    ]
    empty = tmp_path / "empty"
    empty.mkdir()
    with pytest.raises(FileError, match=r"holds no \.brdfpaint file"):
        sheet_items(empty)


def test_names_on_a_sheet_show_what_is_not_seen(lit: View, tmp_path: Path) -> None:
    """A folder and a file can be called by names that no paint can have."""
    seen = []
    for mark in ("\u202e\u200b", "[U+202E][U+200B]"):
        folder = tmp_path / f"Sum{mark}"
        folder.mkdir()
        save_paint(BLUE, folder / "blue.brdfpaint")
        (folder / f"aa{mark}.brdfpaint").write_text("{}")
        made = write_sheet([folder], lit, (240, 30), folder / "sheet.png", 2, form="chips")
        assert (made.paints, len(made.problems)) == (2, 1)
        with Image.open(folder / "sheet.png") as sheet:
            seen.append(np.asarray(sheet))
    np.testing.assert_array_equal(*seen)


def test_a_sheet_as_pages(lit: View, tmp_path: Path) -> None:
    from pypdf import PdfReader

    source, path = tmp_path / "a.brdfpalette", tmp_path / "sheet.pdf"
    more = tuple(Entry(replace(BLUE, name=f"Blau {index}"), group=("Viele",)) for index in range(9))
    save_palette(replace(palette(), entries=(*palette().entries, *more)), source)
    made = write_sheet([source], lit, (60, 40), path, 3, form="chips")
    assert (made.paints, made.pages, made.width) == (12, 2, 0)
    # A chip shows a reading, and needs no paint that has it.
    assert [problem.split(":")[0] for problem in made.problems] == ["Impossible"]
    pages = PdfReader(path).pages
    assert len(pages) == 2
    texts = [page.extract_text() for page in pages]
    assert "Summer" in texts[0]
    assert "Blues" in texts[0]
    for index in range(9):
        assert sum(f"Blau {index}" in text for text in texts) == 1
    assert "could not be drawn" in texts[0]
    first = next(iter(pages[0].images)).image
    assert first.size == (60, 40)
    drawn = write_sheet([source], lit, (40, 30), tmp_path / "drawn.pdf")
    # Pictures of one paint under several names are kept once.
    assert sum(len(page.images) for page in PdfReader(drawn.path).pages) >= 2


def test_paints_of_a_sheet_are_drawn_as_each_alone(lit: View) -> None:
    items = [SheetItem(paint.name, "", paint) for paint in (WHITE, BLUE)]
    pictures = []
    for order in (items, items[::-1]):
        # The first is drawn as any picture is, the others from what was kept of the surface.
        with item_pictures(lit, (40, 30), PictureSettings(), Display(), None) as drawing:
            pictures.append({item.name: drawing.draw(item)[0].astype(int) for item in order})
    for item in items:
        assert np.abs(pictures[0][item.name] - pictures[1][item.name]).max() <= 1
    assert np.abs(pictures[0][WHITE.name] - pictures[0][BLUE.name]).max() > 50


def test_a_sheet_takes_palettes_of_other_programs(shared_data: Path) -> None:
    title, items = sheet_items(shared_data / "palettes" / "ase" / "nord.ase")
    assert title
    assert len(items) > 10
    assert all(item.paint is not None and item.name for item in items)


def test_a_cancelled_sheet_leaves_nothing(lit: View, tmp_path: Path) -> None:
    source = tmp_path / "a.brdfpalette"
    save_palette(palette(), source)
    with pytest.raises(Cancelled):
        write_sheet([source], lit, (40, 30), tmp_path / "sheet.png", progress=stop_at(0.5))
    with pytest.raises(FileError, match="PNG of 8 bits or as PDF"):
        write_sheet([source], lit, (40, 30), tmp_path / "sheet.exr")
    with pytest.raises(ValueRangeError, match="columns"):
        write_sheet([source], lit, (40, 30), tmp_path / "sheet.png", 0)
    assert [file.name for file in tmp_path.iterdir()] == ["a.brdfpalette"]


def test_captions() -> None:
    paint = load_shipped_paint("silver_metallic")
    text = cell_text(
        SheetItem(paint.name, "", paint, code="S1"), fit_material(load_material("silver_metallic"))
    )
    assert (text.name, text.code) == (paint.name, "S1")
    assert text.lines[:2] == [f"flop 18.3, {paint.gloss.gu_20:g} GU at 20°", "15°: L* 108.6  a* 0.3  b* 1.5"]
    solid = SheetItem("White", "", None)
    assert len(cell_text(solid, fit_material(load_material("table1_white"))).lines) == 4


def test_text_fits_and_letters_that_no_font_has_are_reported() -> None:
    font, missing = sheet_text.font_for(["Blue"], 14)
    assert missing == ""
    assert sheet_text.shortened("Blue", font, 200) == "Blue"
    short = sheet_text.shortened("A name that is far too long for its cell", font, 90)
    assert short.endswith("...")
    assert font.getlength(short) <= 90
    assert "\ue123" in sheet_text.font_for(["\ue123 Blue"], 14)[1]
    image = Image.new("L", (200, 40))
    ImageDraw.Draw(image).text((0, 0), "Blue", 255, font)
    assert np.asarray(image).max() > 100
