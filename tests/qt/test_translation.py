"""Dates in the language of the program."""

from __future__ import annotations

from datetime import datetime

import pytest
from brdf_qt.program.translation import moment


@pytest.mark.parametrize(
    ("language", "told"),
    [("en", "21 November 2026, 16:32"), ("de", "21. November 2026, 16:32")],
)
def test_a_moment_is_told_in_the_language_of_the_program(qapp, language, told) -> None:
    before = qapp.property("language")
    qapp.setProperty("language", language)
    try:
        assert moment(datetime(2026, 11, 21, 16, 32)) == told
    finally:
        qapp.setProperty("language", before)
