"""The search over counts: what it gives, that it is the same each time, and that it goes on where it stopped."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.errors import Cancelled, DocumentError, FittingError
from brdf_suite.fitting.basis_search import document
from brdf_suite.fitting.basis_search.database import Database
from brdf_suite.fitting.basis_search.error import MEANING, BasisError, equation_4
from brdf_suite.fitting.basis_search.search import CountResult, search
from brdf_suite.fitting.lobes.basis import stored_bases


@pytest.fixture(scope="module")
def found(few: Database) -> list[CountResult]:
    return search(few, 2, starts=2, workers=1)


def timeless(results: list[CountResult]) -> list[CountResult]:
    return [dataclasses.replace(result, seconds=0.0) for result in results]


def test_each_count_is_better_than_the_last_and_says_its_errors(
    few: Database, found: list[CountResult]
) -> None:
    assert [result.count for result in found] == [1, 2]
    values = [result.value for result in found]
    assert values == sorted(values, reverse=True)
    errors = BasisError(few)
    for result in found:
        np.testing.assert_array_equal(errors(result.exponents), result.errors)
        assert result.value == equation_4(np.array(result.errors))
        assert all(value >= result.value for _, value in result.others)


def test_two_processes_find_the_same_to_the_bit(few: Database, found: list[CountResult]) -> None:
    reported: list[float] = []
    two = search(few, 2, starts=2, workers=2, progress=lambda share, _what: reported.append(share))
    assert timeless(two) == timeless(found)
    assert reported == sorted(reported)
    assert reported[-1] == 1.0


def test_it_goes_on_from_what_is_done(few: Database, found: list[CountResult], tmp_path: Path) -> None:
    settings = document.settings_of(few, 2)
    state = tmp_path / "basis.json.part"
    document.save_state(state, settings, found[:1])
    done = document.load_state(state, settings)
    assert done == found[:1]
    asked = []
    again = search(few, 2, starts=2, workers=1, done=done, found=asked.append)
    assert timeless(again) == timeless(found)
    assert [result.count for result in asked] == [2]


@pytest.mark.parametrize("workers", [1, 2])
def test_cancelling_ends_it_and_its_processes(few: Database, workers: int) -> None:
    def cancel(share: float, _what: str) -> None:
        if share > 0.0:
            raise Cancelled

    kept: list[CountResult] = []
    with pytest.raises(Cancelled):
        search(few, 2, starts=2, workers=workers, progress=cancel, found=kept.append)
    assert len(kept) <= 1


def test_a_state_of_other_paints_or_damaged_is_refused(
    few: Database, found: list[CountResult], tmp_path: Path
) -> None:
    settings = document.settings_of(few, 2)
    state = tmp_path / "basis.json.part"
    assert document.load_state(state, settings) == []
    document.save_state(state, settings, found)
    with pytest.raises(DocumentError, match=r"other paints or other starts.*--fresh"):
        document.load_state(state, {**settings, "starts": 3})
    text = state.read_text()
    for old, new, place in (
        ('"lobe_basis_search"', '"other"', "--fresh"),
        ('"seconds": ', '"seconds": -', "seconds"),
        ('"evaluations": ', '"evaluatoins": ', "evaluations"),
        ('"count": 1', '"count": 1, "more": 2', "more"),
        (text[len(text) // 2 :], "", "line"),
    ):
        assert old in text
        state.write_text(text.replace(old, new, 1))
        with pytest.raises(DocumentError, match=place):
            document.load_state(state, settings)
    document.save_state(state, settings, found[1:])
    with pytest.raises(DocumentError, match="not 1, 2, 3"):
        document.load_state(state, settings)


def test_the_answer_is_read_back(few: Database, found: list[CountResult], tmp_path: Path) -> None:
    path = tmp_path / "basis.json"
    answer = document.save_basis(path, few.names, found, 2, {"command": "test"})
    assert answer["error"] == MEANING
    bases, count = stored_bases(path)
    assert count == 2
    assert {n: basis.exponents for n, basis in bases.items()} == {r.count: r.exponents for r in found}
    with pytest.raises(FittingError, match="no basis of 7"):
        document.save_basis(path, few.names, found, 7, {})
    assert stored_bases(path)[1] == 2


def test_the_rule_takes_the_fewest_lobes_that_are_good_enough(found: list[CountResult]) -> None:
    def of(count: int, value: float) -> CountResult:
        exponents = tuple(float(k + 1) for k in range(count))
        return dataclasses.replace(found[0], exponents=exponents, errors=(0.5 * value,))

    near = 2.0 * document.NEAR_BEST
    assert document.choose_default([of(1, 9.0), of(2, 1.001 * near), of(3, 0.999 * near), of(4, 2.0)]) == 3
    assert document.choose_default([of(1, 9.0), of(2, 4.0), of(3, 5.0)]) == 2


@pytest.mark.parametrize(
    ("largest", "starts", "workers"), [(0, 2, 1), (13, 2, 1), (3, 1, 1), (3, 2, 0), (12, 2, 1)]
)
def test_bad_orders_are_refused(few: Database, largest: int, starts: int, workers: int) -> None:
    with pytest.raises(FittingError, match=r"lobes|starts|paints"):
        search(few, largest, starts=starts, workers=workers)
