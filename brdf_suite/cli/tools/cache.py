"""``brdf-suite cache info|clear|verify``: filtered maps, baked occlusion and pictures of paints kept on disk."""

from __future__ import annotations

import argparse
from datetime import UTC, datetime

from brdf_suite.cli.output import print_json, progress_bar
from brdf_suite.errors import FileError
from brdf_suite.lighting.cache.folder import CacheEntry, remove
from brdf_suite.lighting.cache.map_file import DamagedMapFileError, read_facts
from brdf_suite.lighting.cache.maps import MapCache
from brdf_suite.lighting.cache.occlusion import (
    LIMIT_BYTES,
    damaged_occlusion,
    kept_occlusion,
    occlusion_folder,
)
from brdf_suite.palettes.swatches.store import SwatchStore


def add(command: argparse.ArgumentParser) -> None:
    """Declare the command and what it does."""
    command.description = (
        "The prefiltered maps of environments are kept on disk and found again by the content of the "
        "environment; so are the occlusion that is baked for a surface and the pictures of the paints of palettes. "
        "Nothing is lost with them but the time to make them again."
    )
    command.epilog = (
        "The environment variable BRDF_SUITE_CACHE chooses the folder, BRDF_SUITE_CACHE_MB the largest size "
        "of the maps."
    )
    actions = command.add_subparsers(dest="action", metavar="info|clear|verify", required=True)
    for name, words, run in (
        ("info", "say where the cache is, how large, and what is in it", info),
        ("clear", "remove everything in it", clear),
        ("verify", "read every entry and compare its checksum; status 1 where one is damaged", verify),
    ):
        action = actions.add_parser(name, help=words, description=words[0].upper() + words[1:] + ".")
        action.add_argument("--json", action="store_true", help="print one JSON object")
        action.set_defaults(run=run)
        if name == "verify":
            action.add_argument(
                "--remove", action="store_true", help="remove damaged entries and what killed programs left"
            )


def info(options: argparse.Namespace) -> int:
    """Print the place, the sizes and the entries, the one used last first."""
    cache = MapCache()
    baked = kept_occlusion()
    baked_bytes = sum(size for _, size in baked)
    rows = [_row(entry) for entry in reversed(cache.entries())]
    used = sum(entry.size for entry in cache.entries())
    pictures = SwatchStore()
    number, pictures_bytes = pictures.size() if pictures.path.is_file() else (0, 0)
    if options.json:
        print_json(
            {
                "folder": str(cache.folder),
                "bytes": used,
                "limit_bytes": cache.limit_bytes,
                "unfinished": len(cache.unfinished()),
                "entries": rows,
                "occlusion": {
                    "folder": str(occlusion_folder()),
                    "bytes": baked_bytes,
                    "limit_bytes": LIMIT_BYTES,
                    "entries": [{"entry": path.name, "bytes": size} for path, size in reversed(baked)],
                },
                "swatches": {
                    "file": str(pictures.path),
                    "bytes": pictures_bytes,
                    "limit_bytes": pictures.limit_bytes,
                    "pictures": number,
                },
            }
        )
        return 0
    there, room = _count(len(rows), "entry", "entries"), f"{cache.limit_bytes / 1e6:,.0f} MB"
    print(f"{cache.folder}: {there}, {used / 1e6:,.1f} MB of {room}")
    for row in rows:
        print(
            f"  {row['last_used']}  {int(str(row['bytes'])) / 1e6:8,.1f} MB  {row['environment'] or row['entry']}"
        )
    there, room = _count(len(baked), "surface", "surfaces"), f"{LIMIT_BYTES / 1e6:,.0f} MB"
    print(f"{occlusion_folder()}: {there}, {baked_bytes / 1e6:,.1f} MB of {room}")
    there, room = _count(number, "picture", "pictures"), f"{pictures.limit_bytes / 1e6:,.0f} MB"
    print(f"{pictures.path}: {there}, {pictures_bytes / 1e6:,.1f} MB of {room}")
    return 0


def clear(options: argparse.Namespace) -> int:
    """Empty the cache and print the size of the removed files."""
    cache = MapCache()
    before = cache.entries()
    failed = cache.clear()
    after = {entry.path for entry in cache.entries()}
    gone = [entry for entry in before if entry.path not in after]
    freed = sum(entry.size for entry in gone)
    baked = [(path, size) for path, size in kept_occlusion() if remove(path)]
    stuck = len(kept_occlusion())
    for folder, left in ((cache.folder, failed), (occlusion_folder(), stuck)):
        if left:
            raise FileError(
                folder, f"{_count(left, 'entry', 'entries')} cannot be removed; is the disk read-only"
            )
    baked_bytes = sum(size for _, size in baked)
    pictures = SwatchStore()
    there_were = pictures.path.is_file()
    pictures_bytes = pictures.size()[1] if there_were else 0
    number = pictures.clear() if there_were else 0
    if options.json:
        print_json(
            {
                "folder": str(cache.folder),
                "removed": len(gone),
                "freed_bytes": freed,
                "occlusion": {
                    "folder": str(occlusion_folder()),
                    "removed": len(baked),
                    "freed_bytes": baked_bytes,
                },
                "swatches": {
                    "file": str(pictures.path),
                    "removed": number,
                    "freed_bytes": pictures_bytes,
                },
            }
        )
    else:
        print(f"{cache.folder}: {_count(len(gone), 'entry', 'entries')} removed, {freed / 1e6:,.1f} MB")
        there = _count(len(baked), "surface", "surfaces")
        print(f"{occlusion_folder()}: {there} removed, {baked_bytes / 1e6:,.1f} MB")
        there = _count(number, "picture", "pictures")
        print(f"{pictures.path}: {there} removed, {pictures_bytes / 1e6:,.1f} MB")
    return 0


def verify(options: argparse.Namespace) -> int:
    """Check every entry and print what is damaged; 1 where something is, removed or not."""
    cache = MapCache()
    with progress_bar("checking", quiet=options.json) as progress:
        found = cache.verify(remove=options.remove, progress=progress)
    baked = damaged_occlusion()
    sound = len(kept_occlusion()) - len(baked)
    left = sum(not remove(path) for path, _ in baked) if options.remove else len(baked)
    removed = options.remove and left == 0
    pictures = SwatchStore()
    whole, spoilt = pictures.verify(remove=options.remove) if pictures.path.is_file() else (0, 0)
    passed = found.passed and not baked and not spoilt
    if options.json:
        print_json(
            {
                "folder": str(cache.folder),
                "passed": passed,
                "sound": found.sound,
                "damaged": [{"entry": name, "reason": reason} for name, reason in found.damaged],
                "outdated": found.outdated,
                "unfinished": found.unfinished,
                "removed": found.removed,
                "occlusion": {
                    "folder": str(occlusion_folder()),
                    "sound": sound,
                    "damaged": [{"entry": path.name, "reason": reason} for path, reason in baked],
                    "removed": removed,
                },
                "swatches": {
                    "file": str(pictures.path),
                    "sound": whole,
                    "damaged": spoilt,
                    "removed": options.remove and spoilt > 0,
                },
            }
        )
    else:
        print(f"{cache.folder}: {found.sound} sound, {len(found.damaged)} damaged")
        for name, reason in found.damaged:
            print(f"  {name}: {reason}")
        if found.outdated:
            print(f"  {_count(found.outdated, 'entry', 'entries')} of another version, never read")
        if found.unfinished:
            print(f"  {_count(found.unfinished, 'file', 'files')} unfinished, never read")
        print(f"{occlusion_folder()}: {sound} sound, {len(baked)} damaged")
        for _, reason in baked:
            print(f"  {reason}")
        print(f"{pictures.path}: {whole} sound, {spoilt} damaged")
        if not passed:
            print(
                "removed"
                if (found.removed or not found.damaged) and (removed or not baked) and options.remove
                else "`brdf-suite cache verify --remove` removes what is damaged"
            )
    return 0 if passed else 1


def _row(entry: CacheEntry) -> dict[str, object]:
    """Return one entry as plain values; ``environment`` is empty where the file does not name it."""
    try:
        facts = read_facts(entry.path)
    except (DamagedMapFileError, OSError):
        facts = {}
    exponents = facts.get("exponents")
    return {
        "entry": entry.path.name,
        "environment": str(facts.get("environment", "")),
        "exponents": exponents if isinstance(exponents, list) else [],
        "bytes": entry.size,
        "last_used": datetime.fromtimestamp(entry.last_used, UTC).strftime("%Y-%m-%dT%H:%M:%SZ"),
        "outdated": entry.outdated,
    }


def _count(number: int, one: str, many: str) -> str:
    return f"{number} {one if number == 1 else many}"
