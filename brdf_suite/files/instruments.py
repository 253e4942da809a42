"""What an instrument read, out of a file of any format that holds readings at several angles, known by its content."""

from __future__ import annotations

from dataclasses import replace

from brdf_suite.errors import PathLike
from brdf_suite.files.cxf import is_cxf, read_cxf
from brdf_suite.files.hardened_xml import MOST_BYTES, parse_xml
from brdf_suite.files.samples import SampleFile
from brdf_suite.files.tables.finding import check_cells, find_table
from brdf_suite.files.tables.grid import decode, decode_head, read_rows
from brdf_suite.files.tables.readings import read_samples
from brdf_suite.files.tables.xml_rows import xml_rows
from brdf_suite.regular_files import read_bytes, within_memory

_HEAD = 1 << 16
_MOST_ROWS = 200_000


@within_memory
def read_instrument(path: PathLike) -> SampleFile | None:
    """Return the samples of a file; None for one of any other kind.

    Raises :class:`FileError`: it cannot be read, or is such a file and damaged; with the place.
    """
    content = read_bytes(path, MOST_BYTES)
    head = content[:_HEAD]
    if is_cxf(head):
        return read_cxf(path)
    notes: tuple[str, ...] = ()
    start = decode_head(head).lstrip()[:1]
    if not start or start in "{[":
        return None
    if start == "<":
        rows, notes = xml_rows(parse_xml(content, path), path, _MOST_ROWS)
    else:
        # Whether it is a table at all shows in its first lines.
        text = decode_head(head)
        if find_table(read_rows("\n".join(text.splitlines()[:80]), path, 100)) is None:
            return None
        found = decode(content)
        rows = [] if found is None else read_rows(found[0], path, _MOST_ROWS)
    table = find_table(rows)
    if table is None or not table.is_of_angles:
        return None
    check_cells(table, path)
    found_samples = read_samples(table, path)
    return replace(found_samples, notes=(*found_samples.notes, *notes))
