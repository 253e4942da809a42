"""The cache on real disks that are full or read-only."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

FILL = """
import json, os, sys
from pathlib import Path
import numpy as np
from brdf_suite.lighting.lobe_map_cache import MapCache
from brdf_suite.lighting.environment import Environment
disk = Path(sys.argv[1])
cache = MapCache(disk)
environment = Environment("noise", np.random.default_rng(2).random((8, 16, 3)).astype(np.float32))
answer = {"first": float(cache.get_or_compute(environment, [3.0]).lobes[0].radiance().sum())}
answer |= {"entries": len(cache.entries()), "kept": len(cache.notices) == 0}
if sys.argv[2] == "full":
    space = os.statvfs(disk)
    with (disk / "ballast").open("wb") as ballast:
        ballast.write(bytes(space.f_bavail * space.f_frsize - 50_000))
elif sys.argv[2] == "read-only":
    os.system(f"mount -o remount,ro {disk}")
cache.notices.clear()
answer["again"] = float(cache.get_or_compute(environment, [3.0]).lobes[0].radiance().sum())
answer["hit_notices"] = list(cache.notices)
answer["other"] = float(cache.get_or_compute(environment, [4.0]).lobes[0].radiance().sum())
answer |= {"notices": cache.notices, "unfinished": len(cache.unfinished()), "after": len(cache.entries())}
answer["sound"] = cache.verify().passed
print(json.dumps(answer))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="needs Linux's mount namespaces")
@pytest.mark.parametrize("state", ["full", "read-only"])
def test_a_disk_that_takes_no_more_costs_only_time(state: str, tmp_path: Path) -> None:
    disk = tmp_path / "disk"
    disk.mkdir()
    # A namespace of its own: the mount is gone with the process, whatever becomes of it.
    mount = 'mount -t tmpfs -o size=4m tmpfs "$1" || exit 77; exec "$2" -c "$3" "$1" "$4"'
    done = subprocess.run(
        [
            "unshare",
            "--user",
            "--map-root-user",
            "--mount",
            "sh",
            "-c",
            mount,
            "sh",
            disk,
            sys.executable,
            FILL,
            state,
        ],
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    if done.returncode == 77 or done.stderr.startswith("unshare:"):
        pytest.skip(f"no disk can be mounted here: {done.stderr.strip()}")
    assert done.returncode == 0, done.stderr
    answer = json.loads(done.stdout)
    assert answer["kept"]
    assert answer["entries"] == answer["after"] == 1
    assert answer["again"] == answer["first"] > 0.0
    assert answer["hit_notices"] == []  # what is there is served without a word
    assert answer["other"] > 0.0
    assert (
        "No space left" in answer["notices"][-1] if state == "full" else "Read-only" in answer["notices"][-1]
    )
    assert answer["unfinished"] == 0
    assert answer["sound"]
