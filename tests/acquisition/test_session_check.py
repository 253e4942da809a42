"""A folder of photographs is checked before it is used: each thing that is wrong is reported with its file."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from brdf_suite.acquisition.photographs.exposure_faults import check_exposures
from brdf_suite.acquisition.reconstruction.photographs import FolderSource
from brdf_suite.acquisition.session.check import PositionOrder, check_session
from brdf_suite.acquisition.session.finding import SessionFinding
from brdf_suite.acquisition.session.series import (
    read_calibration,
    read_mask,
    read_position,
)
from brdf_suite.acquisition.session.session import Session
from brdf_suite.acquisition.session.store import read_session, write_session
from brdf_suite.acquisition.session.template import write_template
from brdf_suite.acquisition.simulator import Simulator, SimulatorSettings, simulate
from brdf_suite.acquisition.simulator.folder import write_photograph
from brdf_suite.errors import Cancelled, FileError
from brdf_suite.files.images.exr.image import write_exr
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1

POLARIS = CookTorrance(TABLE_1["table1_polaris_silver"])
SETTINGS = SimulatorSettings(size=(64, 48), angles_deg=(10.0, 40.0, 75.0, 100.0, 130.0), exposures=6)


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("rig") / "session"
    simulate(POLARIS, folder, SETTINGS, "Polaris Silver")
    return folder


@pytest.fixture
def folder(made: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(made, tmp_path / "session"))


class _Kept(Simulator):
    """A rig whose photographs are made once."""

    def __init__(self) -> None:
        super().__init__(POLARIS, SETTINGS, "Polaris Silver")
        self._made: dict[int, np.ndarray] = {}

    def position(self, position: int):
        if position not in self._made:
            self._made[position] = super().position(position)
        return self._made[position]


@pytest.fixture(scope="module")
def rig() -> Simulator:
    return _Kept()


def _check(folder: Path):
    return check_session(folder, read_session(folder))


def test_a_whole_folder_has_no_findings_and_gives_what_was_simulated(made: Path, rig: Simulator) -> None:
    session = read_session(made)
    assert session == rig.session
    assert check_session(made, session) == ()
    np.testing.assert_array_equal(read_position(made, session, 2).codes, rig.position(2))
    series = [read_calibration(made, session, kind) for kind in ("dark", "white", "flat_field")]
    for found, expected in zip(series, (rig.dark(), rig.white(), rig.flat_field()), strict=True):
        assert found is not None
        np.testing.assert_array_equal(found.codes, expected)
    assert (made / "truth.json").is_file()


def test_what_is_missing_or_cut_off_is_named_and_the_rest_is_kept(folder: Path, rig: Simulator) -> None:
    (folder / "light_0001/02.png").unlink()
    half = folder / "light_0003/05.png"
    half.write_bytes(half.read_bytes()[:1000])
    (folder / "dark/00.png").write_bytes(b"")
    findings = _check(folder)
    assert [(f.severity, f.place, f.position, f.exposure) for f in findings] == [
        ("exposure", "positions[1].photographs[2]", 1, 2),
        ("exposure", "positions[3].photographs[5]", 3, 5),
        ("warning", "dark[0]", None, None),
    ]
    assert "is missing" in findings[0].reason
    assert "not copied whole" in findings[1].reason
    assert str(findings[1].error()).startswith(str(half))
    assert _positions_lost(findings) == set()
    kept = read_position(folder, read_session(folder), 1)
    assert kept.exposures == (0, 1, 3, 4, 5)
    np.testing.assert_array_equal(kept.codes, rig.position(1)[[0, 1, 3, 4, 5]])
    assert [f.exposure for f in kept.findings] == [2]
    again = read_position(folder, read_session(folder), 1, leave_out=(2,))
    assert again.findings == ()


def _positions_lost(findings: tuple[SessionFinding, ...]) -> set[int | None]:
    return {finding.position for finding in findings if finding.severity == "position"}


def test_a_position_of_which_nothing_is_left_is_lost(folder: Path) -> None:
    shutil.rmtree(folder / "light_0002")
    findings = _check(folder)
    assert _positions_lost(findings) == {2}
    (reported,) = findings
    assert reported.reason == "is missing; none of the 6 photographs at 75° can be used"
    assert reported.severity == "position"  # the others are kept
    for k in (0, 1, 3, 4):
        shutil.rmtree(folder / f"light_{k:04d}")
    with pytest.raises(FileError, match="none of its photographs"):
        raise next(finding for finding in _check(folder) if finding.severity == "fatal").error()
    with pytest.raises(FileError, match="is missing"):
        read_position(folder, read_session(folder), 0)


def test_a_calibration_of_which_nothing_is_left_is_fatal(folder: Path) -> None:
    """What session.json names is either there or taken out of it by hand; a part of it is enough."""
    (folder / "board/03.png").unlink()
    (reported,) = _check(folder)
    assert (reported.severity, reported.place) == ("warning", "camera.board.photographs[3]")
    source = FolderSource(folder, read_session(folder))
    assert [name for name, _ in source.board()] == [f"board/{k:02d}.png" for k in range(12) if k != 3]
    for name, place in (("dark", "dark[0]"), ("white", "white.photographs[0]")):
        shutil.rmtree(folder / name)
        reported = _check(folder)[-1]
        assert (reported.severity, reported.place) == ("fatal", place)
        assert f"take {name} out of session.json" in reported.reason


def test_a_region_of_the_white_beyond_the_picture_is_fatal(folder: Path) -> None:
    session = read_session(folder)
    assert session.white is not None
    write_session(replace(session, white=replace(session.white, region=(40, 30, 40, 10))), folder)
    (reported,) = _check(folder)
    assert (reported.severity, reported.place) == ("fatal", "white.region")
    assert "64 × 48 pixels, and the region 40, 30, 40, 10" in reported.reason


def test_the_mask_that_lies_in_the_folder_is_checked_too(folder: Path) -> None:
    Image.new("L", (32, 24), 255).save(folder / "mask.png")
    (reported,) = _check(folder)
    assert (reported.severity, reported.place) == ("fatal", "mask")
    assert "is 32 × 24 pixels, and the others are 64 × 48" in reported.reason


def test_floats_among_whole_codes_are_left_out(folder: Path) -> None:
    text = (folder / "session.json").read_text()
    (folder / "session.json").write_text(text.replace("light_0001/02.png", "light_0001/02.exr"))
    write_exr(folder / "light_0001/02.exr", np.ones((48, 64, 3), np.float32))
    (reported,) = _check(folder)
    assert (reported.severity, reported.position, reported.exposure) == ("exposure", 1, 2)
    assert "holds floats, and the other photographs hold whole codes" in reported.reason


def test_exchanged_files_are_seen_by_their_exif(folder: Path) -> None:
    first, second = folder / "light_0001/01.png", folder / "light_0001/04.png"
    first.rename(folder / "kept")
    second.rename(first)
    (folder / "kept").rename(second)
    findings = _check(folder)
    assert [(f.severity, f.exposure) for f in findings] == [("exposure", 1), ("exposure", 4)]
    assert "EXIF" in findings[0].reason
    assert "exposure 4, so that files may have been exchanged" in findings[0].reason


def test_exchanged_pictures_are_left_out_when_they_are_read(folder: Path, rig: Simulator) -> None:
    times, codes = rig.session.exposures_s, rig.position(1)
    for shown, k in ((4, 1), (1, 4)):  # the EXIF says what the session says; the pictures do not
        write_photograph(folder / f"light_0001/{k:02d}.png", codes[shown], times[k])
    assert _check(folder) == ()
    found = read_position(folder, read_session(folder), 1)
    assert found.exposures == (0, 2, 3, 5)
    np.testing.assert_array_equal(found.codes, codes[[0, 2, 3, 5]])
    assert [f.exposure for f in found.findings] == [1, 4]
    for k in range(6):
        write_photograph(folder / f"light_0001/{k:02d}.png", codes[5 - k], times[k])
    with pytest.raises(FileError, match="reverse order"):
        read_position(folder, read_session(folder), 1)


def test_exchanged_positions_are_found_in_the_folder(folder: Path) -> None:
    (folder / "light_0001").rename(folder / "kept")
    (folder / "light_0003").rename(folder / "light_0001")
    (folder / "kept").rename(folder / "light_0003")
    findings = _check(folder)
    assert findings
    assert {f.severity for f in findings} == {"position"}
    assert _positions_lost(findings) <= {1, 2, 3}
    assert "the highlight at column" in findings[0].reason
    assert check_session(folder, read_session(folder), pictures=False) == ()


def test_times_that_differ_from_the_exif_are_reported(folder: Path) -> None:
    session = read_session(folder)
    write_session(replace(session, exposures_s=tuple(2.0 * t for t in session.exposures_s)), folder)
    findings = _check(folder)
    assert {f.severity for f in findings} == {"position", "fatal", "warning"}  # of the dark frames
    assert all("EXIF" in f.reason for f in findings[:-1])
    # Nominal times of a camera differ a little from those that it keeps.
    write_session(replace(session, exposures_s=tuple(1.05 * t for t in session.exposures_s)), folder)
    assert _check(folder) == ()


def test_another_size_and_another_depth_are_reported(folder: Path) -> None:
    write_photograph(folder / "light_0000/00.png", np.zeros((10, 10, 3), np.uint16), 0.00025)
    write_photograph(folder / "light_0000/01.png", np.zeros((48, 64, 3), np.uint8), 0.00105)
    findings = _check(folder)
    reasons = {f.exposure: f.reason for f in findings if f.position == 0}
    assert "is 10 × 10 pixels, and the others are 64 × 48" in reasons[0]
    assert "has 8 bits" in reasons[1]
    found = read_position(folder, read_session(folder), 0)
    assert {f.exposure for f in found.findings} >= {1}


def test_codes_beyond_the_stated_depth_are_refused(folder: Path) -> None:
    session = read_session(folder)
    ten = replace(session, camera=replace(session.camera, bit_depth=10))
    with pytest.raises(FileError, match=r"00\.png.*beyond the 1,023 of 10 bits"):
        read_position(folder, ten, 4)


@pytest.mark.parametrize(
    ("response", "count", "severity", "words"),
    [
        ("linear", 6, "fatal", "never linear"),
        ("unknown", 3, "fatal", "unknown curve, and 3 exposures do not determine it"),
        ("unknown", 6, "warning", "recovered from the exposures"),
        ("srgb", 3, None, ""),
    ],
)
def test_a_jpeg_with_an_unknown_curve(
    folder: Path, response: str, count: int, severity: str | None, words: str
) -> None:
    session = read_session(folder)
    positions = []
    for i, position in enumerate(session.positions[:2]):
        names = tuple(f"jpeg_{i}_{k}.jpg" for k in range(count))
        for name in names:
            Image.fromarray(np.full((48, 64, 3), 90, np.uint8)).save(folder / name)
        positions.append(replace(position, photographs=names))
    camera = replace(session.camera, bit_depth=8, response=response, board=None)
    jpeg = replace(
        session,
        camera=camera,
        positions=tuple(positions),
        exposures_s=session.exposures_s[:count],
        white=None,
        dark=(),
        flat_field=None,
    )
    findings = check_session(folder, jpeg)
    if severity is None:
        assert findings == ()
        return
    assert [f.severity for f in findings] == [severity]
    assert words in findings[0].reason
    assert findings[0].path.endswith("jpeg_0_0.jpg")


def test_a_check_can_be_cancelled(made: Path) -> None:
    def stop(fraction: float, what: str) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        check_session(made, read_session(made), stop)


def test_masks_are_joined(folder: Path) -> None:
    session = read_session(folder)
    assert read_mask(folder, session) is None
    upper, left = np.zeros((48, 64), np.uint8), np.zeros((48, 64), np.uint8)
    upper[:24], left[:, :32] = 255, 255
    Image.fromarray(upper).save(folder / "mask.png")
    Image.fromarray(left).save(folder / "left.png")
    named = replace(
        session, positions=(replace(session.positions[0], mask="left.png"), *session.positions[1:])
    )
    found = read_mask(folder, named, 0)
    assert found is not None
    np.testing.assert_array_equal(found, (upper > 0) & (left > 0))
    np.testing.assert_array_equal(read_mask(folder, named, 1), upper > 0)
    Image.fromarray(left[:9]).save(folder / "left.png")
    with pytest.raises(FileError, match=r"left\.png: is 64 × 9 pixels"):
        read_mask(folder, named, 0)


def _exposures(rig: Simulator, order: list[int]):
    names = [f"{k:02d}.png" for k in range(6)]
    codes = rig.position(1)[order]
    return check_exposures(codes, rig.session.exposures_s, names, 12, position=1, folder="x")


def test_exposures_in_order_have_no_findings(rig: Simulator) -> None:
    for k in range(len(SETTINGS.angles_deg)):
        assert check_exposures(rig.position(k), rig.session.exposures_s, ["a"] * 6, 12) == ()


def test_exchanged_files_are_seen_by_their_brightness(rig: Simulator) -> None:
    findings = _exposures(rig, [0, 3, 2, 1, 4, 5])
    assert [(f.severity, f.exposure) for f in findings] == [("exposure", 1), ("exposure", 3)]
    assert "brighter than 03.png" in findings[0].reason
    assert "darker than 01.png" in findings[1].reason


def test_wrong_orders_are_reported(rig: Simulator) -> None:
    (reverse,) = _exposures(rig, [5, 4, 3, 2, 1, 0])
    assert (reverse.severity, reverse.position) == ("position", 1)
    assert "reverse order" in reverse.reason
    (wrong,) = _exposures(rig, [0, 1, 2, 3, 0, 5])
    assert (wrong.severity, wrong.exposure) == ("exposure", 4)
    (mixed,) = _exposures(rig, [2, 4, 0, 5, 1, 3])
    assert "by brightness they are 02.png, 04.png, 00.png, 05.png, 01.png, 03.png" in mixed.reason


def test_what_is_saturated_everywhere_is_reported(rig: Simulator) -> None:
    codes = rig.position(1).copy()
    codes[5] = 4095
    names, times = [f"{k:02d}.png" for k in range(6)], rig.session.exposures_s
    (one,) = check_exposures(codes, times, names, 12, position=1, folder="x")
    assert (one.severity, one.exposure, one.path) == ("exposure", 5, str(Path("x/05.png")))
    assert "saturated" in one.reason
    codes[:] = 4095
    (every,) = check_exposures(codes, times, names, 12, position=1)
    assert every.severity == "position"


def _order(session: Session, rig: Simulator, shown: list[int]):
    order = PositionOrder(session, "x")
    for k, which in enumerate(shown):
        order.add(k, rig.position(which))
    return order.findings()


def test_positions_out_of_order_are_reported(rig: Simulator) -> None:
    assert _order(rig.session, rig, [0, 1, 2, 3, 4]) == ()
    (wrong,) = _order(rig.session, rig, [0, 1, 2, 0, 4])
    assert (wrong.severity, wrong.position) == ("position", 3)
    assert "between those of 10° and 40°" in wrong.reason or "that of 10°" in wrong.reason
    (reverse,) = _order(rig.session, rig, [4, 3, 2, 1, 0])
    assert reverse.severity == "fatal"


def test_the_template_takes_what_the_files_state(made: Path, tmp_path: Path) -> None:
    folder = Path(shutil.copytree(made, tmp_path / "mine"))
    (folder / "session.json").unlink()
    for k, angle in enumerate(SETTINGS.angles_deg):
        (folder / f"light_{k:04d}").rename(folder / f"lamp at {angle:g}")
    written = write_template(folder)
    session, truth = read_session(folder), read_session(made)
    assert session.exposures_s == pytest.approx(truth.exposures_s, rel=1e-5)
    assert [p.angle_deg for p in session.positions] == list(SETTINGS.angles_deg)
    assert session.camera.bit_depth == 12
    assert session.dark == truth.dark
    assert session.camera.board is not None
    assert session.flat_field is not None
    assert written.photographs == len(session.files())
    assert any("sphere.radius_m" in note for note in written.notes)
    assert check_session(folder, session) == ()
    with pytest.raises(FileError, match="not overwritten"):
        write_template(folder)


def test_the_template_of_an_empty_folder_proposes_names(tmp_path: Path) -> None:
    written = write_template(tmp_path / "new")
    session = read_session(tmp_path / "new")
    assert (len(session.positions), len(session.exposures_s)) == (180, 16)
    assert "no photographs yet" in written.notes[0]


def test_the_template_of_float_photographs_is_linear_and_angles_may_be_unknown(tmp_path: Path) -> None:
    for name in ("right", "left"):
        (tmp_path / name).mkdir()
        for k in range(3):
            write_exr(tmp_path / name / f"{k}.exr", np.full((4, 4, 3), 0.1 * k, np.float32))
    written = write_template(tmp_path)
    session = read_session(tmp_path)
    assert session.camera.response == "linear"
    assert [p.angle_deg for p in session.positions] == [0.0, 180.0]
    assert any("even steps" in note for note in written.notes)
    assert any("state no times" in note for note in written.notes)


def test_a_template_of_uneven_or_loose_photographs_is_refused(tmp_path: Path) -> None:
    for name in ("a/0.png", "a/1.png", "b/0.png"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        write_photograph(tmp_path / name, np.zeros((4, 4, 3), np.uint16), 0.01)
    with pytest.raises(FileError, match="each position has one for each exposure"):
        write_template(tmp_path)
    write_photograph(tmp_path / "loose.png", np.zeros((4, 4, 3), np.uint16), 0.01)
    shutil.rmtree(tmp_path / "a")
    shutil.rmtree(tmp_path / "b")
    with pytest.raises(FileError, match="into a folder of their own"):
        write_template(tmp_path)


def test_a_simulation_overwrites_nothing(made: Path) -> None:
    with pytest.raises(FileError, match="is not empty"):
        simulate(POLARIS, made, SETTINGS)


def test_a_cancelled_simulation_leaves_no_session(tmp_path: Path) -> None:
    def stop(fraction: float, what: str) -> None:
        if fraction > 0.3:
            raise Cancelled

    with pytest.raises(Cancelled):
        simulate(POLARIS, tmp_path / "x", replace(SETTINGS, board=False), progress=stop)
    assert not (tmp_path / "x/session.json").exists()
