"""The path tracer, where it can run: Mitsuba is an optional extra, and on processors it needs the library LLVM."""

from __future__ import annotations

import pytest

from brdf_suite.errors import ReferenceUnavailableError
from brdf_suite.reference.variant import Variant, start


@pytest.fixture(scope="session")
def variant() -> Variant:
    """The variant of Mitsuba that was started; without one the test is skipped, and says why."""
    try:
        return start()
    except ReferenceUnavailableError as error:
        pytest.skip(str(error))
