"""``brdf-suite cache info|clear|verify``: filtered maps, baked occlusion and pictures of paints kept on disk."""

from __future__ import annotations

import argparse
from datetime import UTC, datetime
from typing import Any

from brdf_suite.cli.arguments import add_json
from brdf_suite.cli.output import print_csv, print_json, progress_bar
from brdf_suite.command_parser import CommandParser
from brdf_suite.errors import FileError
from brdf_suite.files.array_file import read_header
from brdf_suite.files.cache.disk_cache import CacheEntry
from brdf_suite.files.meshes.occlusion_cache import occlusion_cache
from brdf_suite.lighting.lobe_map_cache import PLAIN, MapCache
from brdf_suite.palettes.swatches.store import SwatchStore


def add(command: CommandParser) -> None:
    """Declare the command and what it does."""
    command.description = (
        "The prefiltered maps of environments are kept on disk and found again by the content of the "
        "environment; so are the occlusion that is baked for a surface and the pictures of the paints of palettes. "
        "Nothing is lost with them but the time to make them again."
    )
    command.epilog = (
        "The environment variable BRDF_SUITE_CACHE chooses the folder, BRDF_SUITE_CACHE_MB the largest size "
        "of maps and occlusion."
    )
    command.examples = ("brdf-suite cache info", "brdf-suite cache verify --remove")
    actions = command.add_subparsers(dest="action", metavar="info|clear|verify", required=True)
    for name, words, run in (
        ("info", "say where the cache is, how large, and what is in it", info),
        ("clear", "remove everything in it", clear),
        ("verify", "read every entry and compare its checksum; status 1 where one is damaged", verify),
    ):
        action = actions.add_parser(name, help=words, description=words[0].upper() + words[1:] + ".")
        action.examples = (f"brdf-suite cache {name}",)
        add_json(action, csv=name == "info")
        action.set_defaults(run=run)
        if name == "verify":
            action.add_argument(
                "--remove", action="store_true", help="remove damaged entries and what killed programs left"
            )


def info(options: argparse.Namespace) -> int:
    """Print the place, the sizes and the entries, the one used last first."""
    cache, occlusion, pictures = MapCache(), occlusion_cache(), SwatchStore()
    rows = [_row(entry) for entry in reversed(cache.entries())]
    baked = occlusion.entries()
    used, baked_bytes = (sum(entry.size for entry in kind.entries()) for kind in (cache, occlusion))
    number, pictures_bytes = pictures.size()
    if options.json:
        print_json(
            {
                "folder": str(cache.folder),
                "bytes": used,
                "limit_bytes": cache.limit_bytes,
                "unfinished": len(cache.unfinished()),
                "entries": rows,
                "occlusion": {
                    "folder": str(occlusion.folder),
                    "bytes": baked_bytes,
                    "limit_bytes": occlusion.limit_bytes,
                    "entries": [{"entry": e.path.name, "bytes": e.size} for e in reversed(baked)],
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
    if options.csv:
        print_csv({**row, "exponents": len(row["exponents"])} for row in rows)
        return 0
    print(f"{cache.folder}: {_count(len(rows), 'entry', 'entries')}, {_share(used, cache.limit_bytes)}")
    for row in rows:
        print(
            f"  {row['last_used']}  {int(str(row['bytes'])) / 1e6:8,.1f} MB  {row['environment'] or row['entry']}"
        )
    there = _count(len(baked), "surface", "surfaces")
    print(f"{occlusion.folder}: {there}, {_share(baked_bytes, occlusion.limit_bytes)}")
    there = _count(number, "picture", "pictures")
    print(f"{pictures.path}: {there}, {_share(pictures_bytes, pictures.limit_bytes)}")
    return 0


def clear(options: argparse.Namespace) -> int:
    """Empty the cache and print the size of the removed files."""
    cache, occlusion, pictures = MapCache(), occlusion_cache(), SwatchStore()
    removed: list[tuple[int, int]] = []
    for kind in (cache, occlusion):
        before = kind.entries()
        if failed := kind.clear():
            raise FileError(
                kind.folder, f"{_count(failed, 'entry', 'entries')} cannot be removed; is the disk read-only"
            )
        removed.append((len(before), sum(entry.size for entry in before)))
    pictures_bytes = pictures.size()[1]
    removed.append((pictures.clear(), pictures_bytes))
    if options.json:
        maps, baked, drawn = ({"removed": number, "freed_bytes": size} for number, size in removed)
        print_json(
            {
                "folder": str(cache.folder),
                **maps,
                "occlusion": {"folder": str(occlusion.folder), **baked},
                "swatches": {"file": str(pictures.path), **drawn},
            }
        )
        return 0
    words = (("entry", "entries"), ("surface", "surfaces"), ("picture", "pictures"))
    for place, (number, size), (one, many) in zip(
        (cache.folder, occlusion.folder, pictures.path), removed, words, strict=True
    ):
        print(f"{place}: {_count(number, one, many)} removed, {size / 1e6:,.1f} MB")
    return 0


def verify(options: argparse.Namespace) -> int:
    """Check every entry and print what is damaged; 1 where something is, removed or not."""
    cache, occlusion, pictures = MapCache(), occlusion_cache(), SwatchStore()
    with progress_bar("checking", quiet=options.json) as progress:
        found = cache.verify(remove_damaged=options.remove, progress=progress)
    baked = occlusion.verify(remove_damaged=options.remove)
    whole, spoilt = pictures.verify(remove=options.remove)
    passed = found.passed and baked.passed and not spoilt
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
                    "folder": str(occlusion.folder),
                    "sound": baked.sound,
                    "damaged": [{"entry": name, "reason": reason} for name, reason in baked.damaged],
                    "removed": baked.removed,
                },
                "swatches": {
                    "file": str(pictures.path),
                    "sound": whole,
                    "damaged": spoilt,
                    "removed": options.remove and spoilt > 0,
                },
            }
        )
        return 0 if passed else 1
    for kind, checked in ((cache, found), (occlusion, baked)):
        print(f"{kind.folder}: {checked.sound} sound, {len(checked.damaged)} damaged")
        for _, reason in checked.damaged:
            print(f"  {reason}")
        if checked.outdated:
            print(f"  {_count(checked.outdated, 'entry', 'entries')} of another version, never read")
        if checked.unfinished:
            print(f"  {_count(checked.unfinished, 'file', 'files')} unfinished, never read")
    print(f"{pictures.path}: {whole} sound, {spoilt} damaged")
    if not passed:
        print(
            "removed"
            if options.remove and found.removed and baked.removed
            else "`brdf-suite cache verify --remove` removes what is damaged"
        )
    return 0 if passed else 1


def _row(entry: CacheEntry) -> dict[str, Any]:
    """Return one entry as plain values; ``environment`` is empty where the file does not name it."""
    try:
        facts = read_header(PLAIN, entry.path)
    except FileError:
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


def _share(used: int, limit: int) -> str:
    return f"{used / 1e6:,.1f} MB of {limit / 1e6:,.0f} MB"


def _count(number: int, one: str, many: str) -> str:
    return f"{number} {one if number == 1 else many}"
