"""Look up the pinned packages in the database of known vulnerabilities: ``packaging/audit.py``; status 1 for any found.

Without a way to the database it says so and ends with status 0: a machine without a network checks all else.
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

LOCK = Path(__file__).resolve().parent / "lock.txt"
ACCEPTED: dict[str, str] = {}
"""Vulnerabilities that do not concern the suite, by their names, each with the reason."""
_PATIENCE_S = 180.0


def main() -> int:
    """Print what is known of the packages, and return the exit status."""
    options = [
        "--requirement",
        str(LOCK),
        "--no-deps",
        "--disable-pip",
        "--format",
        "json",
        "--timeout",
        "15",
    ]
    ignored = [word for name in ACCEPTED for word in ("--ignore-vuln", name)]
    command = [sys.executable, "-P", "-m", "pip_audit", "--progress-spinner", "off", *options, *ignored]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=_PATIENCE_S, check=False)
        packages = json.loads(done.stdout)["dependencies"]
    except (subprocess.TimeoutExpired, ValueError, KeyError) as error:
        said = "" if isinstance(error, subprocess.TimeoutExpired) else done.stderr.strip()
        reason = said.splitlines()[-1] if said else f"no answer within {_PATIENCE_S:.0f} s"
        print(f"Skipped: the database of vulnerabilities cannot be asked ({reason[:200]}).")
        return 0
    found = [(package, vuln) for package in packages for vuln in package.get("vulns", [])]
    for package, vuln in found:
        fixed = ", ".join(vuln["fix_versions"]) or "no version yet"
        print(f"{package['name']} {package['version']}: {vuln['id']}, mended in {fixed}")
    print(f"{len(packages)} packages looked up, {len(found)} vulnerabilities known.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
