"""Dates and numbers in the language of the program."""

from __future__ import annotations

from datetime import datetime

import pytest
from brdf_qt.fields.number import NumberField
from brdf_qt.program.translation import decimal, moment, point, tr


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


@pytest.fixture
def in_german(qapp):
    """The decimal sign of German, as a program in that language has it."""
    before = qapp.property("language")
    qapp.setProperty("language", "de")
    tr.cache_clear()
    point.cache_clear()
    yield
    qapp.setProperty("language", before)
    point.cache_clear()


def test_numbers_in_texts_and_fields_have_the_comma(in_german, qtbot) -> None:
    text = tr("ΔE {error:.2f} of {name}, {count}, {whole:d}")
    assert text.format(error=1.25, name="v1.5 red", count="0.75", whole=3) == "ΔE 1,25 of v1.5 red, 0,75, 3"
    assert decimal(f"{-0.5:.1f}") == "-0,5"
    assert decimal(f"{49152:,}") == "49.152"  # a comma is the decimal sign there
    assert tr("{count:,}, {size:,.1f}").format(count=5856, size=1234.5) == "5.856, 1.234,5"
    field = NumberField("Gloss", "GU", 0.0, 200.0, 0.5, 1, 90.5)
    qtbot.addWidget(field)
    assert field.text() == "90,5 GU"
    for typed in ("12,5", "12.5"):
        field.setValue(0.0)
        field.lineEdit().setText(f"{typed} GU")
        field.interpretText()
        assert field.value() == 12.5


def test_english_keeps_the_point(qapp) -> None:
    assert tr("{value:.1f}").format(value=2.5) == "2.5"
