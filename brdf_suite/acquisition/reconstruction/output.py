"""A whole reconstruction in one call, and where its table goes: taken up again where it was, nothing overwritten."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from brdf_suite.acquisition.reconstruction.reconstruction import Acquisition
from brdf_suite.acquisition.reconstruction.table import Acquired, kept_work, reconstruct
from brdf_suite.documents.atomic import check_target
from brdf_suite.errors import FileError
from brdf_suite.files.measured.brdftable import write_brdftable
from brdf_suite.files.measured.merl import write_merl
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable


def work_path(output: Path) -> Path:
    """Return the work file that belongs to an output file."""
    return output.with_name(output.name + ".work")


def acquire(
    acquisition: Acquisition,
    output: Path,
    progress: Progress | None = None,
    *,
    overwrite: bool = False,
    restart: bool = False,
) -> Acquired:
    """Take all steps of ``acquisition``, write ``output`` (``.brdftable`` or ``.binary``), and return what was written.

    What is done is kept in ``OUTPUT.work`` until the output is whole: after a cancellation, a kill, or a failure the
    same call goes on where it was.

    Raises
    ------
    FileError
        ``output`` exists and may not be overwritten, has another ending, or cannot be written; the work file is
        another reconstruction's.
    SuiteError
        As the steps.
    """
    check_output(output, overwrite)
    work = work_path(output)
    kept = None if restart else kept_work(acquisition, work)
    if kept is None:
        # What nothing can be made of is refused, and warnings are kept for the user.
        report(progress, 0.0, "checking the files")
        for finding in acquisition.source.findings(None):
            if finding.severity == "fatal":
                raise finding.error()
            if finding.severity == "warning":
                acquisition.notice(f"{finding.path}: {finding.reason}.")
        acquisition.calibrate(subrange(progress, 0.0, 0.25))
    else:
        acquisition.take_calibration(kept[0])
    found = reconstruct(acquisition, subrange(progress, 0.25, 0.99), work, restart=restart)
    write_acquired(found, output, overwrite=overwrite)
    work.unlink()
    return found


def acquire_partial(
    acquisition: Acquisition,
    output: Path,
    progress: Progress | None = None,
    *,
    overwrite: bool = False,
    restart: bool = False,
) -> Acquired:
    """Write the table of the positions that an unfinished :func:`acquire` has done; its work file stays.

    Raises
    ------
    FileError
        As :func:`acquire`; or nothing is done yet. ``restart`` contradicts the wish and is refused so.
    """
    check_output(output, overwrite)
    work = work_path(output)
    kept = None if restart else kept_work(acquisition, work)
    if kept is None or not kept[1]:
        raise FileError(work, "holds no finished position, so there is nothing to write yet")
    acquisition.take_calibration(kept[0])
    acquisition.options = replace(acquisition.options, positions=tuple(sorted(kept[1])))
    found = reconstruct(acquisition, progress, work)
    write_acquired(found, output, overwrite=overwrite)
    return found


def check_output(output: Path, overwrite: bool = False) -> None:
    """Raise :class:`FileError` where ``output`` could not be written in the end."""
    if output.suffix.lower() not in WRITERS:
        reason = f"a table goes into one of {', '.join(WRITERS)}; give it one of these endings"
        raise FileError(output, reason)
    check_target(output, overwrite=overwrite)


def write_acquired(found: Acquired, output: Path, *, overwrite: bool = False) -> tuple[str, ...]:
    """Write a table as its ending says, whole or not at all; return notes."""
    check_output(output, overwrite)
    return WRITERS[output.suffix.lower()](found.table, output)


def _write_merl(table: IsotropicTable, path: Path) -> tuple[str, ...]:
    return (*write_merl(table, path), "coverage and uncertainty are not held by this format")


WRITERS: dict[str, Callable[[IsotropicTable, Path], tuple[str, ...]]] = {
    ".brdftable": write_brdftable,
    ".binary": _write_merl,
}
