"""The look-up of known vulnerabilities is left out with a word where its database cannot be reached."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest


def test_without_a_network_it_is_skipped_with_a_word(checkout: Path) -> None:
    pytest.importorskip("pip_audit")
    nowhere = "http://127.0.0.1:9"  # the port of a service that no system offers any more
    variables = dict.fromkeys(
        ("HTTPS_PROXY", "https_proxy", "HTTP_PROXY", "http_proxy", "ALL_PROXY"), nowhere
    )
    done = subprocess.run(
        [sys.executable, str(checkout / "packaging" / "audit.py")],
        env={**os.environ, **variables, "NO_PROXY": "", "no_proxy": ""},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("Skipped: the database of vulnerabilities cannot be asked (")
