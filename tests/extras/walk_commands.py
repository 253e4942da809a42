"""``walk_commands.py ANSWERS``: runs commands of ``brdf-suite``, a JSON list of argument lists on the input.

Writes a line of JSON per command to the file ANSWERS: its exit status and what it wrote. The standard output and
error are those of the processes that a command starts.

Commands that use the light ``light.exr`` share the cache of the tests: the same light is filtered by others too. The
rest has a cache of its own, in the folder ``cache``, since ``cache clear`` empties it.
"""

from __future__ import annotations

import contextlib
import io
import json
import os
import sys
from pathlib import Path

from brdf_suite.cli.main import main


def run(arguments: list[str]) -> dict[str, object]:
    """Run one command as the console script does."""
    output, errors = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
        try:
            status = main(arguments)
        except SystemExit as end:
            status = end.code
    return {"status": status, "output": output.getvalue(), "errors": errors.getvalue()}


if __name__ == "__main__":
    with Path(sys.argv[1]).open("w", encoding="utf-8") as answers:
        shared = os.environ["BRDF_SUITE_CACHE"]
        for each in json.load(sys.stdin):
            os.environ["BRDF_SUITE_CACHE"] = shared if "light.exr" in each else str(Path("cache").absolute())
            print(json.dumps(run(each)), file=answers, flush=True)
