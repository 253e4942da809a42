"""What every plug-in can test of itself: the suite's own checks."""

from __future__ import annotations

from brdf_suite_example.paint_list import FORMAT
from brdf_suite_example.velvet import MODEL

from brdf_suite.testing import check_model, check_palette_format


def test_the_model_keeps_what_it_claims() -> None:
    check_model(MODEL)


def test_the_palette_format_reads_what_it_writes() -> None:
    check_palette_format(FORMAT, b"paintlist 1\nff8000 Orange\n004080 Night\n")
