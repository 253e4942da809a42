"""Batches: one step with thousands of paints."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Executor
from contextlib import nullcontext
from pathlib import Path
from typing import Literal, get_args

from brdf_suite.batches.items import list_lights, list_paints
from brdf_suite.batches.running import BatchResult, run_batch
from brdf_suite.batches.steps import BatchStep, Export, Factorize, Fit, Measure, Prefilter, Render
from brdf_suite.batches.workers import BatchWorkers, start_workers
from brdf_suite.documents.view import View
from brdf_suite.errors import PathLike, ValueRangeError
from brdf_suite.pipeline.scene import default_view
from brdf_suite.progress import Progress

StepName = Literal["measure", "fit", "render", "prefilter", "factorize", "export"]


def batch(
    step: StepName,
    sources: PathLike | Sequence[PathLike],
    folder: PathLike,
    *,
    geometry: str = "six",
    aperture: str = "point",
    texture: bool = True,
    view: View | None = None,
    size: tuple[int, int] = (640, 360),
    format: str = "cxf",
    workers: int | None = None,
    memory: str | None = None,
    scheduler: str | None = None,
    executor: Executor | None = None,
    group: int | None = None,
    progress: Progress | None = None,
) -> BatchResult:
    """Do one step with every paint of palettes, folders and names, on all cores or on a cluster.

    The folder gets ``results.csv`` and ``results.parquet`` with a row for each item, pictures or other files, a palette
    of the paints and ``summary.html``. A batch that was stopped goes on where it was when it is called again: items are
    known by the hash of their content. An item that fails is reported and left out. A script calls this below ``if
    __name__ == "__main__":``, since worker processes import it.

    Parameters
    ----------
    step
        ``measure`` (with ``geometry``, ``aperture`` and ``texture``, as of :func:`measure`), ``fit``, ``render`` (with
        ``view`` and ``size``), ``prefilter`` (sources are environments), ``factorize``, or ``export`` (with
        ``format``, one of ``names("formats")``).
    sources
        Names, files, palettes of any format, and folders with all that lies below them.
    folder
        Of the results. On a cluster all workers must see it, and the sources.
    workers
        Processes on this machine; default: one a core. Each has one thread.
    memory
        The most that one of these may take, as ``"2GB"``.
    scheduler
        Of a Dask cluster: ``tcp://HOST:PORT``.
    executor
        What does the work instead, with the interface of ``concurrent.futures.Executor``; ``workers`` is then how much
        it does at once.
    group
        Items that a worker takes at once, 1 to 1,024; left out, as many as take about 2 s.
    progress
        Called with a share, 0 to 1, and a sentence; it may raise ``brdf_suite.errors.Cancelled``.

    Raises
    ------
    SuiteError
        A folder of the sources holds nothing, the extra ``batches`` is not installed, the folder cannot be written, or
        the workers are lost. What cannot be read is among ``problems`` of the result.

    >>> import brdf_suite as bs, concurrent.futures, tempfile
    >>> with concurrent.futures.ThreadPoolExecutor(1) as one:
    ...     done = bs.batch("measure", ["blue", "copper"], tempfile.mkdtemp(), executor=one)
    >>> done.items, done.problems
    (2, ())
    """
    steps: dict[str, Callable[[], BatchStep]] = {
        "measure": lambda: Measure(geometry, aperture, texture),
        "fit": Fit,
        "render": lambda: Render(view or default_view(), size),
        "prefilter": Prefilter,
        "factorize": Factorize,
        "export": lambda: Export(format),
    }
    if step not in steps:
        raise ValueRangeError("step", f"expected one of {', '.join(get_args(StepName))}, not {step!r}")
    given = _names(sources)
    find = list_lights if step == "prefilter" else list_paints
    items = find(given, Path(folder))
    if executor is not None:
        hired = BatchWorkers(executor, lambda: workers or 1)
        return run_batch(
            steps[step](), items, Path(folder), lambda: nullcontext(hired), group=group, progress=progress
        )
    return run_batch(
        steps[step](),
        items,
        Path(folder),
        lambda: start_workers(scheduler, None, workers, memory),
        group=group,
        progress=progress,
    )


def _names(sources: object) -> list[PathLike]:
    """Return the sources as a list; raise :class:`ValueRangeError` where one is no name, and no path."""
    names: list[PathLike] = []
    for one in sources if isinstance(sources, Iterable) and not isinstance(sources, str) else [sources]:
        if not isinstance(one, str | os.PathLike):
            wanted = "expected names, files, palettes and folders"
            raise ValueRangeError("sources", f"{wanted}, not a {type(one).__name__}")
        names.append(one)
    return names
