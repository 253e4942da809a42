"""Columns of a palette, what is found in them, their orders and duplicates."""

from __future__ import annotations

import math
import tracemalloc

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.appearance.flop.travel import flop_index, travel
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Gloss, Measurement, Paint, solid_paint
from brdf_suite.documents.palette import Entry
from brdf_suite.errors import Cancelled, ValueRangeError
from brdf_suite.palettes import order
from brdf_suite.palettes.columns import Columns, ColumnsWork, labs_of, same_contents
from brdf_suite.palettes.duplicates import _WEIGHTS, duplicates
from brdf_suite.palettes.order import ORDERS, hue_path, ordered, path_length
from brdf_suite.palettes.search import (
    COMBINATIONS,
    Filter,
    Texts,
    in_hue_range,
    lower_bound,
    matching,
    nearest,
)
from brdf_suite.pipeline.material import load_document, load_shipped_paint

ANGLES = (15.0, 45.0, 110.0)


def paint(name: str, labs: np.ndarray, gloss: float = 90.0) -> Paint:
    readings = tuple(
        Measurement(45.0, angle, tuple(lab)) for angle, lab in zip(ANGLES, labs.tolist(), strict=True)
    )
    return Paint(name, readings, Gloss(gloss))


def many(count: int, seed: int = 0) -> list[Entry]:
    """Paints that lie thick in places, with pairs that are nearly the same."""
    rng = np.random.default_rng(seed)
    face = np.stack([rng.uniform(5, 95, count), *(rng.normal(0, 25, count) for _ in range(2))], axis=1)
    face[1::7] = face[::7][: len(face[1::7])] + rng.normal(0, 0.2, face[1::7].shape)
    flop = rng.uniform(1.0, 2.2, (count, 1))
    flop[1::7] = flop[::7][: len(flop[1::7])]
    near, far = face * [1, 1.1, 1.1], face * [1, 0.8, 0.8]
    near[:, :1] = np.minimum(face[:, :1] * flop, 140.0)
    far[:, :1] = face[:, :1] / flop
    labs = np.stack([near, np.abs(face * [1, 0, 0]) + face * [0, 1, 1], far], axis=1)
    labs[..., 0] = np.clip(labs[..., 0], 0.0, 250.0)
    return [Entry(paint(f"Paint {i}", labs[i]), id=str(i)) for i in range(count)]


@pytest.fixture(scope="module")
def columns() -> Columns:
    return Columns.of(many(1500))


def test_columns_hold_readings_flop_and_travel() -> None:
    blue = load_shipped_paint("blue")
    columns = Columns.of([Entry(blue), Entry(FlatColour("ink", "Lab", (50.0, 20.0, 0.0), "", "D65", 10))])
    assert columns.main[0].tolist() == [list(blue.lab_at(angle)) for angle in ANGLES]
    assert columns.read.all()
    assert columns.flop[0] == pytest.approx(flop_index(*columns.main[0, :, 0]).value)
    assert columns.travel[0] == pytest.approx(travel(ANGLES, columns.main[0]).length)
    assert columns.gloss[0] == blue.gloss.gu_20
    assert columns.main[1] == pytest.approx(np.tile([50.0, 20.0, 0.0], (3, 1)))
    assert columns.flop[1] == 0.0
    assert math.isnan(columns.gloss[1])
    assert columns.hue[1] == pytest.approx(0.0)


def test_what_was_not_read_is_what_the_reflectance_gives_and_is_worked_out_in_pieces() -> None:
    from brdf_suite.appearance.colour.colorimetry import working_to_lab
    from brdf_suite.palettes.swatches.look import colours_at
    from brdf_suite.reflectance.designed.build import build_reflectance

    measured = load_document("table1_opel_titan")
    assert isinstance(measured, CookTorrancePaint)
    blue = load_shipped_paint("blue")
    work = ColumnsWork([Entry(blue), Entry(measured)], (25.0,))
    first = work.columns
    assert work.left == 2
    assert first.waiting.tolist() == [True, True]
    assert np.isnan(first.at(25.0)).all()
    assert np.isfinite(first.at(45.0)[0]).all()
    assert work.step(1)
    assert not work.step(1)
    done = work.columns
    assert not done.waiting.any()
    for row, kind in enumerate((blue, measured)):
        wanted = working_to_lab(colours_at(build_reflectance(kind), np.array([25.0])))[0]
        assert done.at(25.0)[row] == pytest.approx(wanted)
    assert not done.read[:, 1].any()
    assert labs_of(blue, (45.0, 15.0)).tolist() == [list(blue.lab_at(45.0)), list(blue.lab_at(15.0))]


def test_rows_of_paints_that_stay_are_taken_over() -> None:
    entries = many(20)
    known = Columns.of(entries, (25.0,))
    changed = [*entries[5:], Entry(load_shipped_paint("red"), id="new")]
    work = ColumnsWork(changed, (25.0,), known)
    assert work.left == 1
    work.finish()
    fresh = Columns.of(changed, (25.0,))
    assert np.array_equal(work.columns.lab, fresh.lab)
    assert np.array_equal(work.columns.gloss, fresh.gloss)


@pytest.mark.parametrize("combine", COMBINATIONS)
def test_the_nearest_are_those_of_a_comparison_with_all(columns: Columns, combine: str) -> None:
    rng = np.random.default_rng(3)
    spared = 0
    for _ in range(12):
        wanted = columns.main[rng.integers(len(columns))] + rng.normal(
            0, rng.choice([0.5, 5.0, 40.0]), (3, 3)
        )
        each = delta_e_2000(wanted, columns.lab)
        combined = each.mean(axis=1) if combine == "mean" else each.max(axis=1)
        found = nearest(columns, wanted, 25, combine)  # type: ignore[arg-type]
        assert found.indices.tolist() == np.argsort(combined, kind="stable")[:25].tolist()
        assert np.array_equal(found.delta_e, combined[found.indices])
        assert np.array_equal(found.per_angle, each[found.indices])
        spared += len(columns) - found.compared
    assert spared > 0.3 * 12 * len(columns)


LAB = st.tuples(st.floats(0.0, 250.0), st.floats(-250.0, 250.0), st.floats(-250.0, 250.0))


@settings(max_examples=3 * settings.default.max_examples)
@given(LAB, LAB)
def test_the_bound_is_never_above_the_difference(one: tuple[float, ...], other: tuple[float, ...]) -> None:
    assert float(lower_bound(one, other)) <= float(delta_e_2000(one, other)) + 1e-9


def test_unknown_angles_do_not_count_and_unknown_paints_are_not_found(columns: Columns) -> None:
    wanted = columns.main[7].copy()
    wanted[0] = np.nan
    found = nearest(columns, wanted, 3)
    assert found.indices[0] == 7
    assert np.isnan(found.per_angle[:, 0]).all()
    among = np.ones(len(columns), bool)
    among[7] = False
    assert 7 not in nearest(columns, wanted, 3, among=among).indices
    with pytest.raises(ValueRangeError, match="none of the angles"):
        nearest(columns, np.full((3, 3), np.nan))
    with pytest.raises(ValueRangeError, match="3 angles"):
        nearest(columns, np.zeros((2, 3)))
    assert len(nearest(Columns.of([]), wanted).indices) == 0


def test_filters_keep_ranges_tags_groups_and_a_hue_range_over_zero(columns: Columns) -> None:
    wanted = Filter(hue=(330.0, 30.0), lightness=(20.0, 60.0), flop=(0.0, 10.0))
    shown = matching(columns, wanted)
    h = columns.hue
    assert np.array_equal(
        shown,
        ((h >= 330.0) | (h <= 30.0))
        & (columns.lightness >= 20.0)
        & (columns.lightness <= 60.0)
        & (columns.flop <= 10.0),
    )
    assert 0 < shown.sum() < len(columns)
    assert in_hue_range([10.0, float("nan")], 0.0, 360.0).tolist() == [True, False]
    white = solid_paint("w", (95.0, 0.0, 0.0))
    tagged = Columns.of([Entry(white, tags=("Sun", "new"), group=("A", "B")), Entry(white, group=("A",))])
    assert matching(tagged, Filter(tags=("sun",))).tolist() == [True, False]
    assert matching(tagged, Filter(group=("A", "B"))).tolist() == [True, False]
    assert matching(tagged, Filter(group=("A",))).tolist() == [True, True]
    assert matching(Columns.of([]), Filter(text="x")).tolist() == []


@pytest.mark.parametrize(
    ("typed", "found"),
    [
        ("STRASSE", [0]),
        ("metallise", [1]),
        ("métallisé", [1]),
        ("mëtallise", []),
        ("メタリック", [2]),
        ("か", []),
        ("ab 12", [3]),
        ("blau straße", [0]),
        ("ГОЛУБОЙ", [4]),
        ("  ", [0, 1, 2, 3, 4]),
    ],
)
def test_words_are_found_in_any_script_and_case(typed: str, found: list[int]) -> None:
    named = [
        Entry(solid_paint("Straße", (50.0, 0.0, 0.0)), tags=("Blau",)),
        Entry(solid_paint("Gris MÉTALLISÉ", (50.0, 0.0, 0.0))),
        Entry(solid_paint("ﾒﾀﾘｯｸ が", (50.0, 0.0, 0.0))),
        Entry(solid_paint("x", (50.0, 0.0, 0.0)), code="AB-12", notes="of 2012\nab"),
        Entry(solid_paint("голубой", (50.0, 0.0, 0.0))),
    ]
    assert np.flatnonzero(Texts(named).matching(typed)).tolist() == found


@pytest.mark.parametrize("by", ORDERS)
@pytest.mark.parametrize("descending", [False, True])
def test_orders_are_whole_and_stable(columns: Columns, by: str, descending: bool) -> None:
    twice = Columns.of([*columns.entries[:200], *columns.entries[:200]])
    order = ordered(twice, by, descending=descending)  # type: ignore[arg-type]
    assert sorted(order.tolist()) == list(range(400))
    if by != "hue path":
        # What is alike stays as it was: of two copies the first comes first, and in the order of the first ones.
        where = np.empty(400, int)
        where[order] = np.arange(400)
        assert (where[:200] < where[200:]).all()


def test_orders_by_numbers_names_and_dates() -> None:
    entries = [
        Entry(solid_paint("Blue 10", (30.0, 0.0, -20.0)), code="b2", date="2024-05-01"),
        Entry(solid_paint("blue 2", (60.0, 0.0, 0.5))),
        Entry(solid_paint("Äther", (45.0, 30.0, 5.0)), code="B10", date="2023-01-31"),
    ]
    columns = Columns.of(entries)
    assert ordered(columns, "name").tolist() == [2, 1, 0]
    assert ordered(columns, "code").tolist() == [0, 2, 1]
    assert ordered(columns, "date").tolist() == [2, 0, 1]
    assert ordered(columns, "date", descending=True).tolist() == [0, 2, 1]
    assert ordered(columns, "lightness", descending=True).tolist() == [1, 2, 0]
    assert ordered(columns, "hue").tolist() == [2, 0, 1]
    assert ordered(columns, "hue", descending=True).tolist() == [0, 2, 1]


def test_the_hue_path_jumps_less_than_hues_in_order(columns: Columns) -> None:
    lab = columns.main[:, 1]
    path = hue_path(lab)
    assert path_length(lab[path]) < 0.4 * path_length(lab[ordered(columns, "hue")])
    greys = np.hypot(lab[path, 1], lab[path, 2]) < 4.0
    assert greys[: greys.sum()].all()
    assert (np.diff(lab[path, 0][: greys.sum()]) >= 0.0).all()


def test_duplicates_are_the_parts_that_hang_together() -> None:
    columns = Columns.of(many(260, 5))
    tolerance = 1.5
    each = delta_e_2000(columns.lab[:, None], columns.lab[None]).max(axis=-1)
    alike = each <= tolerance
    reached = np.linalg.matrix_power(alike.astype(float), 32) > 0.0
    wanted = {tuple(np.flatnonzero(row).tolist()) for row in reached if row.sum() > 1}
    found = duplicates(columns, tolerance)
    assert {group.indices for group in found} == wanted
    assert len(wanted) > 12
    assert any(len(group) > 2 for group in wanted)
    for group in found:
        own = each[np.ix_(group.indices, group.indices)]
        assert group.widest == pytest.approx(own.max())
        assert group.chained == bool((own > tolerance).any())


def cloud(spread: float, count: int = 1300) -> Columns:
    """Entries around one paint."""
    rng = np.random.default_rng(3)
    lab = rng.normal((50.0, 5.0, 8.0), spread, (count, 3, 3))
    none = np.zeros(count)
    return Columns((), ANGLES, lab, np.ones((count, 3), bool), none, none > 0.0)


def test_many_alike_take_little_memory_report_and_can_be_cancelled() -> None:
    columns, fractions = cloud(0.1), []
    tracemalloc.start()
    try:
        (group,) = duplicates(columns, 1.0, lambda fraction, _: fractions.append(fraction))
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert group.indices == tuple(range(1300))
    assert math.isnan(group.widest)
    assert not group.chained
    # All pairs at once would take over 100 MB.
    assert peak < 40e6
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1.0
    # Comparing and measuring are both long, and both report.
    assert sum(0.0 < fraction < 0.8 for fraction in fractions) > 10
    assert sum(0.8 < fraction < 1.0 for fraction in fractions) > 100

    def stop(fraction: float, what: str) -> None:
        if fraction > 0.9:
            raise Cancelled

    with pytest.raises(Cancelled):
        duplicates(columns, 1.0, stop)


@pytest.mark.parametrize("tolerance", [0.5, 1.0, 2.0])
def test_a_large_group_says_rightly_whether_it_is_a_chain(tolerance: float) -> None:
    columns = cloud(0.11, 1100)
    lab = columns.lab
    widest = max(float(delta_e_2000(row, lab[i:]).max()) for i, row in enumerate(lab))
    groups = duplicates(columns, tolerance)
    assert len(groups[0].indices) > 1000
    assert groups[0].chained == (widest > tolerance)


@given(LAB, LAB)
def test_the_weighted_distance_is_never_below_the_difference(
    one: tuple[float, ...], other: tuple[float, ...]
) -> None:
    near = np.array(one) + 0.02 * (np.array(other) - np.array(one))
    for second in (np.array(other), near):
        bound = float(np.linalg.norm((second - one) * _WEIGHTS))
        assert float(delta_e_2000(one, second)) <= bound * (1.0 + 1e-9) + 1e-9


def test_a_chain_is_reported_and_copies_are_found_at_no_tolerance() -> None:
    entries = [Entry(solid_paint("g", (50.0 + 0.8 * step, 0.0, 0.0))) for step in (0, 1, 2, 2)]
    columns = Columns.of([*entries, Entry(solid_paint("far", (90.0, 0.0, 0.0)))])
    (chain,) = duplicates(columns, 1.0)
    assert chain.indices == (0, 1, 2, 3)
    assert chain.chained
    assert chain.widest > 1.0
    (copies,) = duplicates(columns, 0.0)
    assert copies.indices == (2, 3)
    assert not copies.chained
    assert copies.widest == 0.0
    assert duplicates(Columns.of([])) == ()
    with pytest.raises(ValueRangeError, match="tolerance"):
        duplicates(columns, -1.0)

    def stop(fraction: float, what: str) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        duplicates(columns, 1.0, stop)


@given(
    st.lists(st.integers(0, 12), max_size=12),
    st.lists(st.integers(0, 12), max_size=12),
)
def test_the_same_contents_are_found_wherever_they_went(before: list[int], after: list[int]) -> None:
    paints = [solid_paint(str(n), (50.0, 0.0, 0.0)) for n in range(13)]
    # Each once on either side: of copies a place may be missed.
    known = [Entry(paints[n]) for n in dict.fromkeys(before)]
    entries = [Entry(paints[n], code="changed" if n % 2 else "") for n in dict.fromkeys(after)]
    entries = [next((k for k in known if k == entry), entry) for entry in entries]
    found = same_contents(entries, known)
    wanted = [next((p for p, k in enumerate(known) if k.content is e.content), -1) for e in entries]
    assert found.tolist() == wanted


@pytest.mark.parametrize("descending", [False, True])
def test_an_order_by_name_is_stable_over_its_runs(descending: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(order, "_RUN", 7)
    names = [("", "Blue 10", "blue 2", "Äther", "Azur", "Blue 2")[n * n % 6] for n in range(60)]
    entries = [Entry(FlatColour(name, "Gray", (0.5,)), id=str(n)) for n, name in enumerate(names)]
    named = [place for place, name in enumerate(names) if name]
    wanted = sorted(named, key=lambda place: order.natural(names[place]), reverse=descending)
    wanted += [place for place, name in enumerate(names) if not name]
    assert ordered(Columns.of(entries), "name", descending=descending).tolist() == wanted
