"""Dates in the language of the program."""

from __future__ import annotations

from datetime import datetime

import pytest
from brdf_qt.program.translation import moment


@pytest.mark.parametrize(
    ("language", "reported"),
    [("en", "21 November 2026, 16:32"), ("de", "21. November 2026, 16:32")],
)
def test_a_moment_is_in_the_language_of_the_program(qapp, language, reported) -> None:
    before = qapp.property("language")
    qapp.setProperty("language", language)
    try:
        assert moment(datetime(2026, 11, 21, 16, 32)) == reported
    finally:
        qapp.setProperty("language", before)
