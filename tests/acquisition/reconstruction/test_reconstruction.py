"""From a folder of photographs to a table: the road whole, stopped, killed, and with bad photographs."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.acquisition.geometry.lens import lens_pixels
from brdf_suite.acquisition.reconstruction.options import (
    AcquireOptions,
    coverage_map,
    covered_share,
    deviation_map,
    within,
)
from brdf_suite.acquisition.reconstruction.output import acquire, acquire_partial, work_path, write_acquired
from brdf_suite.acquisition.reconstruction.reconstruction import Acquisition
from brdf_suite.acquisition.reconstruction.table import Acquired, figures_of, reconstruct
from brdf_suite.acquisition.session.series import PhotographSeries
from brdf_suite.acquisition.session.store import write_session
from brdf_suite.acquisition.simulator import Simulator, SimulatorSettings, simulate
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.errors import AcquisitionError, Cancelled, FileError, ValueRangeError
from brdf_suite.files.images.png import write_png
from brdf_suite.files.measured.brdftable import read_brdftable
from brdf_suite.files.measured.merl import read_merl
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from tools.evaluation.simulated_source import SimulatorSource

PAINT = CookTorrance(TABLE_1["table1_opel_titan"])
POSITIONS = 12
BINS = (30, 30, 60)
OPTIONS = AcquireOptions(bins=BINS)
"""Bins of three times the usual width: the steps are the same, and the tables small."""


class Photographed(SimulatorSource):
    """A source that traces each photograph once, however often it is read."""

    def __init__(self, simulator: Simulator) -> None:
        super().__init__(simulator)
        self.taken: dict[int, PhotographSeries] = {}

    def position(self, k: int) -> PhotographSeries:
        if k not in self.taken:
            self.taken[k] = super().position(k)
            self.taken[k].codes.flags.writeable = False
        return self.taken[k]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Photographs of a simulated rig: nine positions, eight exposures, noise, and an unknown response curve."""
    folder = tmp_path_factory.mktemp("rig") / "titan"
    settings = SimulatorSettings(
        size=(144, 144),
        positions=POSITIONS,
        exposures=8,
        longest_s=0.032,
        board=False,
        flat_field=False,
        white=False,
    )
    simulate(PAINT, folder, settings, "Opel Titan", None)
    return folder


@pytest.fixture(scope="module")
def whole(folder: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Acquired, Path]:
    """The table of an undisturbed run."""
    output = tmp_path_factory.mktemp("whole") / "titan.brdftable"
    return acquire(Acquisition.open(folder, OPTIONS), output), output


@pytest.fixture
def own(folder: Path, tmp_path: Path) -> Path:
    """A copy of the folder that a test may spoil."""
    return Path(shutil.copytree(folder, tmp_path / "own"))


def same(one: IsotropicTable, other: IsotropicTable) -> bool:
    assert one.coverage is not None
    assert other.coverage is not None
    return (
        np.array_equal(one.values, other.values)
        and np.array_equal(one.holes, other.holes)
        and np.array_equal(one.coverage.samples, other.coverage.samples)
        and np.array_equal(one.coverage.deviation, other.coverage.deviation)
    )


def errors(table: IsotropicTable) -> np.ndarray:
    """Relative errors of the measured bins below 75°."""
    there = within(table, 75.0) & ~np.asarray(table.holes)
    found = []
    for h in range(table.grid.theta_h):
        wi, wo = table.grid.pairs(h)
        truth = PAINT.eval(wi[there[h]], wo[there[h]])
        found.append(np.abs(table.values[h][there[h]] / truth - 1.0).mean(axis=1))
    return np.concatenate(found)


def test_the_table_is_near_the_paint(whole: tuple[Acquired, Path]) -> None:
    found, output = whole
    assert found.positions_done == tuple(range(POSITIONS))
    assert not found.positions_failed
    assert np.median(errors(found.table)) < 0.04
    document = figures_of(found)
    assert document["readings"] > 5_000
    assert json.loads(json.dumps(document)) == document
    assert not work_path(output).exists()
    assert [file.name for file in output.parent.iterdir()] == [output.name]


def test_a_sphere_that_moves_is_measured_where_it_stood_longest() -> None:
    settings = SimulatorSettings(
        size=(112, 112),
        angles_deg=tuple(10.0 * k for k in range(1, 14)),
        exposures=4,
        curve="linear",
        moved=(5, 2.0, 1.0),
        board=False,
        white=False,
    )
    simulator = Simulator(CookTorrance(TABLE_1["table1_polaris_silver"]), settings)
    road = Acquisition(Photographed(simulator), OPTIONS)
    road.calibrate()
    assert road.geometry is not None
    assert road.refinement is not None
    assert road.refinement.moved_positions == tuple(range(5))
    assert set(road.left_out) == set(range(5))
    assert any("has moved by" in notice for notice in road.notices)
    # In the sum over all positions the centre comes out a fifth of a pixel aside.
    x, y, z = simulator.truth["sphere_centres_m"][5]  # type: ignore[index]  # the truth is plain JSON
    expected = lens_pixels(simulator.optics.lens, np.array((x, -y, settings.camera_distance_m - z)))
    off = lens_pixels(road.geometry.lens, road.geometry.centre) - expected
    assert np.linalg.norm(off) < 0.11


def test_the_file_keeps_coverage_and_facts(whole: tuple[Acquired, Path]) -> None:
    found, output = whole
    table = read_brdftable(output)
    assert isinstance(table, IsotropicTable)
    assert same(table, found.table)
    assert table.coverage is not None
    assert table.coverage.samples.sum() == pytest.approx(found.readings, rel=1e-3)
    assert np.array_equal(table.coverage.samples > 0.0, ~np.asarray(table.holes))
    assert table.facts["positions"] == POSITIONS
    assert table.facts["calibration_response"] == "recovered"
    assert table.source == "Opel Titan"


def test_coverage_for_a_plot(whole: tuple[Acquired, Path]) -> None:
    table = whole[0].table
    shares = coverage_map(table, 75.0)
    assert shares.shape == (30, 30)
    assert np.nanmax(shares) > 0.3
    assert np.isnan(shares[29, 29])
    assert 0.0 < covered_share(table, 75.0) < covered_share(table, 75.0) + 1e-9 < 1.0
    deviations = deviation_map(table)
    assert np.array_equal(np.isnan(deviations), (table.coverage.samples == 0.0).all(axis=2).T)


def test_merl_holds_the_same_values_and_holes(
    folder: Path, whole: tuple[Acquired, Path], tmp_path: Path
) -> None:
    output = tmp_path / "titan.binary"
    notes = write_acquired(whole[0], output)
    assert any("coverage" in note for note in notes)
    again = read_merl(output)
    assert np.array_equal(again.holes, whole[0].table.holes)
    known = ~np.asarray(again.holes)
    near = np.isclose(again.values[known], whole[0].table.values[known], rtol=1e-4, atol=1e-4)
    # Noise of a dark bin lies outside of Rec. 709 now and then.
    assert near.mean() > 0.99


def test_nothing_is_overwritten_unasked(folder: Path, whole: tuple[Acquired, Path], tmp_path: Path) -> None:
    output = tmp_path / "old.brdftable"
    output.write_text("precious")
    with pytest.raises(FileError, match=r"exists already.*--overwrite"):
        acquire(Acquisition.open(folder, OPTIONS), output)
    with pytest.raises(FileError, match="exists already"):
        write_acquired(whole[0], output)
    assert output.read_text() == "precious"
    write_acquired(whole[0], output, overwrite=True)
    assert isinstance(read_brdftable(output), IsotropicTable)
    with pytest.raises(FileError, match=r"\.brdftable, \.binary"):
        acquire(Acquisition.open(folder, OPTIONS), tmp_path / "table.txt")
    with pytest.raises(FileError, match="folder does not exist"):
        acquire(Acquisition.open(folder, OPTIONS), tmp_path / "nowhere" / "a.binary")


KILLED = """
import sys
from pathlib import Path
from brdf_suite.acquisition.reconstruction.reconstruction import Acquisition
from brdf_suite.acquisition.reconstruction.options import AcquireOptions
from brdf_suite.acquisition.reconstruction.output import acquire

def progress(fraction, what):
    if what.startswith("position 5 "):
        print("four are done", flush=True)
        sys.stdin.read()  # for ever: the other end kills this process

options = AcquireOptions(bins=(30, 30, 60))
acquire(Acquisition.open(Path(sys.argv[1]), options), Path(sys.argv[2]), progress)
"""


def test_a_killed_run_goes_on_and_gives_the_same_table(
    folder: Path, whole: tuple[Acquired, Path], tmp_path: Path
) -> None:
    output = tmp_path / "titan.brdftable"
    command = [sys.executable, "-c", KILLED, str(folder), str(output)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == b"four are done\n"
        process.kill()
        process.wait()
    assert not output.exists()
    # What is done may be had at once.
    early = tmp_path / "early.brdftable"
    shutil.copy(work_path(output), work_path(early))
    partial = acquire_partial(Acquisition.open(folder, OPTIONS), early)
    assert partial.positions_done == (0, 1, 2, 3)
    assert work_path(early).exists()
    assert 0 < partial.readings < whole[0].readings
    # And the rest of it later.
    steps: list[str] = []
    found = acquire(Acquisition.open(folder, OPTIONS), output, lambda _, what: steps.append(what))
    assert found.resumed == 4
    assert same(found.table, whole[0].table)
    assert output.read_bytes() == whole[1].read_bytes()
    assert not work_path(output).exists()
    assert not [step for step in steps if "response" in step or "geometry" in step]


def cancelling(at: str) -> Callable[[float, str], None]:
    def progress(_: float, what: str) -> None:
        if what.startswith(at):
            raise Cancelled

    return progress


def test_a_cancelled_run_keeps_what_it_did(
    folder: Path, whole: tuple[Acquired, Path], tmp_path: Path
) -> None:
    output = tmp_path / "a.brdftable"
    with pytest.raises(Cancelled):
        acquire(Acquisition.open(folder, OPTIONS), output, cancelling("reading for the response"))
    assert not work_path(output).exists()
    with pytest.raises(Cancelled):
        acquire(Acquisition.open(folder, OPTIONS), output, cancelling("position 3 "))
    assert not output.exists()
    # Other options would not fit to what was done; what was done is not lost by asking.
    other = Acquisition.open(folder, AcquireOptions(grazing_deg=70.0, bins=BINS))
    with pytest.raises(FileError, match=r"other options.*--restart"):
        acquire(other, output)
    with pytest.raises(Cancelled):
        acquire(Acquisition.open(folder, OPTIONS), output, cancelling("position 6 "))
    found = acquire(Acquisition.open(folder, OPTIONS), output)
    assert found.resumed == 5
    assert same(found.table, whole[0].table)


def test_a_changed_photograph_is_read_again(own: Path, whole: tuple[Acquired, Path], tmp_path: Path) -> None:
    output = tmp_path / "a.brdftable"
    with pytest.raises(Cancelled):
        acquire(Acquisition.open(own, OPTIONS), output, cancelling("position 8 "))
    road = Acquisition.open(own, OPTIONS)
    first, second = (own / name for name in road.session.positions[2].photographs[4:6])
    content = second.read_bytes()
    second.write_bytes(content + b"\0")
    found = acquire(road, output)
    assert found.resumed == 6, found.positions_failed
    second.write_bytes(content)
    assert first.exists()


def test_a_half_copied_folder_gives_what_it_can(own: Path, tmp_path: Path) -> None:
    road = Acquisition.open(own, OPTIONS)
    for name in road.session.positions[7].photographs:
        (own / name).unlink()
    one = road.session.positions[3].photographs[2]
    (own / one).write_bytes((own / one).read_bytes()[:300])
    found = acquire(road, tmp_path / "a.brdftable")
    assert set(found.positions_done) == set(range(POSITIONS)) - {7}
    assert [left.position for left in found.positions_failed] == [7]
    assert road.session.positions[7].photographs[0] in found.positions_failed[0].reason
    assert any(one in sentence for sentence in found.notices)
    assert np.median(errors(found.table)) < 0.05


def test_positions_that_lack_different_photographs_give_the_same_response(
    own: Path, whole: tuple[Acquired, Path]
) -> None:
    road = Acquisition.open(own, OPTIONS)
    for k, exposure in ((0, 1), (3, 5), (6, 3)):
        (own / road.session.positions[k].photographs[exposure]).unlink()
    found = road.calibrate_response()
    assert found is not None
    expected = whole[0].calibration.response
    assert expected is not None
    codes = slice(300, 3600)
    np.testing.assert_allclose(np.log(found.exposure[:, codes] / expected.exposure[:, codes]), 0.0, atol=0.02)


def test_nothing_readable_is_reported_with_its_reason(own: Path, tmp_path: Path) -> None:
    road = Acquisition.open(own, OPTIONS)
    for position in road.session.positions:
        for name in position.photographs:
            (own / name).unlink()
    with pytest.raises((FileError, AcquisitionError), match="none of its photographs"):
        acquire(road, tmp_path / "a.brdftable")
    assert list(tmp_path.glob("a.*")) == []


def test_a_mask_takes_readings_away(own: Path, whole: tuple[Acquired, Path]) -> None:
    road = Acquisition.open(own, OPTIONS)
    used = np.ones((144, 144), np.bool_)
    used[:, :65] = False
    road.take_calibration(whole[0].calibration)
    road.options = replace(road.options, mask=used, positions=(4,))
    masked = reconstruct(road)
    road.options = AcquireOptions(bins=BINS, positions=(4,))
    free = reconstruct(road)
    assert 0 < masked.readings < free.readings
    write_png(own / "mask.png", np.where(used, np.uint8(255), np.uint8(0))[..., None])
    write_session(replace(road.session, mask="mask.png"), own)
    again = Acquisition.open(own, AcquireOptions(bins=BINS, positions=(4,)))
    again.take_calibration(whole[0].calibration)
    assert same(reconstruct(again).table, masked.table)


def test_partial_tables_come_while_the_work_goes_on(folder: Path, whole: tuple[Acquired, Path]) -> None:
    road = Acquisition.open(folder, AcquireOptions(bins=BINS, positions=(3, 4, 5), compare=True))
    road.take_calibration(whole[0].calibration)
    shares = []
    found = reconstruct(
        road, partial=lambda done, of, table: shares.append((done, of, covered_share(table())))
    )
    assert [(done, of) for done, of, _ in shares] == [(1, 3), (2, 3), (3, 3)]
    assert shares[0][2] < shares[1][2] < shares[2][2]
    assert set(found.compared) == {"linear", "traditional"}


def test_steps_out_of_order_say_which_comes_first(folder: Path) -> None:
    road = Acquisition.open(folder, OPTIONS)
    with pytest.raises(AcquisitionError, match="Response and geometry come first"):
        reconstruct(road)
    with pytest.raises(AcquisitionError, match="response comes first"):
        road.merged_stack(road.stack(0), 0)
    road.options = AcquireOptions(bins=BINS, positions=(99,))
    with pytest.raises(ValueRangeError, match="positions 0 to 11"):
        road.calibrate()


def test_a_matt_sphere_stands_as_stated() -> None:
    matt = CookTorrance(CookTorrancePaint("chalk", (0.5, 0.5, 0.5)))
    settings = SimulatorSettings(
        size=(144, 144),
        positions=6,
        exposures=4,
        longest_s=0.002,
        curve="srgb",
        board=False,
        white=False,
        dark=False,
        flat_field=False,
    )
    road = Acquisition(Photographed(Simulator(matt, settings, "chalk")), OPTIONS)
    road.calibrate()
    assert road.refinement is None
    assert road.geometry == road.outline.geometry
    assert any("stand as stated" in sentence for sentence in road.notices)
