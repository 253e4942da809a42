"""Workers of a batch: processes of this machine, or those of a cluster, behind one executor.

Dask brings them (extra ``batches``); anything with the interface of ``concurrent.futures.Executor`` does, too.
"""

from __future__ import annotations

import gc
import logging
import math
import os
import re
from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from contextlib import AbstractContextManager, ExitStack, contextmanager
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import Any

from brdf_suite.errors import SuiteError
from brdf_suite.extras import import_extra
from brdf_suite.processes import interrupts_held_back, shell_interpreter, variables_inherited

_WORKER_VARIABLES = {
    # One worker is one thread, also of Mesa's software renderer.
    "LP_NUM_THREADS": "1",
    "MKL_NUM_THREADS": "1",
    "NUMBA_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
    # Dask's own value, which it sets in this process too.
    "PYTHONHASHSEED": "6640",
    # No Python file of the working folder is imported.
    "PYTHONSAFEPATH": "1",
    # Of glibc, bytes: it keeps the memory of arrays for the next ones. Giving it back each time takes a quarter of a
    # measure's time, and more where several workers do so at once.
    "MALLOC_MMAP_THRESHOLD_": str(32 << 20),
    "MALLOC_TRIM_THRESHOLD_": str(16 << 20),
}
_PURPOSE = "a batch"
_ANSWER_S = 20.0
_WORKERS_S = 600.0
_LEAST_MEMORY = 256 << 20
"""Bytes; a worker has taken half of that before its first paint."""
_START_S = 120.0
"""Time in which a process has to begin."""
_JOB_CLUSTERS = {
    "htcondor": "HTCondor",
    "local": "Local",
    "lsf": "LSF",
    "moab": "Moab",
    "oar": "OAR",
    "pbs": "PBS",
    "sge": "SGE",
    "slurm": "SLURM",
}
JOB_SYSTEMS = tuple(_JOB_CLUSTERS)
_IN_A_SCRIPT = 'A script starts its batch below `if __name__ == "__main__":`, since workers import it.'


@dataclass(frozen=True)
class BatchWorkers:
    """An executor, how many items it works on at once (0: none now), and whether it can still be reached.

    ``replace_lost`` is called again and again: it asks for workers in the place of those that are gone for good, where
    that is possible. A batch ends after ``patience_s`` without any.
    """

    executor: Executor
    width: Callable[[], int]
    reached: Callable[[], bool] = lambda: True
    replace_lost: Callable[[], None] = lambda: None
    patience_s: float = math.inf


@contextmanager
def local_workers(count: int | None = None, memory: str | None = None) -> Iterator[BatchWorkers]:
    """Start worker processes on this machine: ``count`` of them (default: one a core), each with one thread.

    ``memory`` is the most that one may take, as in ``2GB``; default: its share of this machine's. A worker that takes
    more, or dies, is replaced, and its items go to another.

    Raises
    ------
    SuiteError
        Dask is not installed, or there is no such amount of memory.
    """
    distributed, dask = _dask()
    count = count or len(
        os.sched_getaffinity(0) if hasattr(os, "sched_getaffinity") else range(os.cpu_count() or 1)
    )
    try:
        limit = None if memory is None else dask.utils.parse_bytes(memory)
    except ValueError as error:
        raise SuiteError(f"{memory!r} is no amount of memory; write it as 2GB.") from error
    if limit is not None and limit < _LEAST_MEMORY:
        raise SuiteError(
            f"{memory!r} is too little memory for a worker; it takes at least {_LEAST_MEMORY >> 20}MiB."
        )
    # Dask sets them in this process too, prefers what it finds there, and leaves them.
    inherited = variables_inherited(_WORKER_VARIABLES | {"__DASK_PARENT_PID": str(os.getpid())})
    with inherited, _quiet(distributed), dask.config.set(_settings()), ExitStack() as ends:
        try:
            with interrupts_held_back():
                cluster = distributed.LocalCluster(
                    n_workers=count,
                    threads_per_worker=1,
                    processes=True,
                    memory_limit="auto" if limit is None else limit,
                    dashboard_address="127.0.0.1:0",  # any free port: several batches run at once
                    security=True,  # other users of this machine can reach its ports
                    death_timeout=_START_S,
                    silence_logs=logging.CRITICAL,
                )
                ends.enter_context(
                    cluster
                )  # here: an interrupt that was held back comes at the end of the block
        except (RuntimeError, TimeoutError) as error:
            reason = " ".join(str(error).splitlines())
            raise SuiteError(f"The workers do not start: {reason} {_IN_A_SCRIPT}") from error
        client = ends.enter_context(distributed.Client(cluster))
        yield replace(
            _workers_of(client), replace_lost=lambda: replace_lost(cluster, count), patience_s=_WORKERS_S
        )


@contextmanager
def scheduler_workers(address: str) -> Iterator[BatchWorkers]:
    """Use the workers of a running scheduler, ``tcp://HOST:PORT``; :class:`SuiteError` where none answers or works."""
    distributed, dask = _dask()
    if not re.fullmatch(rf"({'|'.join(distributed.comm.registry.backends)})://.+", address):
        raise SuiteError(f"{address!r} is no address of a scheduler; expected tcp://HOST:PORT.")
    with dask.config.set(_settings()), _quiet(distributed):
        try:
            client = distributed.Client(address, timeout=_ANSWER_S, set_as_default=False)
        except (OSError, ValueError, TypeError) as error:  # TypeError: tls without a certificate
            client, reason = None, str(error)
        if client is None:
            # The client that could not be made ends itself; at the end of the interpreter it would wait for an answer.
            gc.collect()
            raise SuiteError(f"No scheduler answers at {address}: {reason}")
        with client:
            _wait_for_workers(client, address)
            yield _workers_of(client)


@contextmanager
def job_workers(system: str, count: int) -> Iterator[BatchWorkers]:
    """Ask a job system for workers, by ``dask-jobqueue`` and its own configuration file, and give them back after.

    Raises
    ------
    SuiteError
        The package is not installed, or its configuration is not complete.
    """
    distributed, dask = _dask()
    import_extra("dask_jobqueue", purpose="a batch on a job system")
    kind = job_cluster_class(system)
    with dask.config.set(_settings()), _quiet(distributed):
        try:
            cluster = kind(n_workers=count, python=job_interpreter(system))
        except (ValueError, OSError, RuntimeError) as error:
            given = dask.config.get(f"jobqueue.{system}", {})
            missing = [name for name in ("cores", "memory") if not given.get(name)]
            reason = " ".join(str(error).splitlines())
            if missing:
                reason = f"{' and '.join(missing)} of a job are not set"
            raise SuiteError(
                f"{system}: {reason}; see the section jobqueue: {system}: of Dask's settings, as in "
                f"{Path(dask.config.PATH) / 'jobqueue.yaml'}."
            ) from error
        with cluster, distributed.Client(cluster, set_as_default=False) as client:
            _wait_for_workers(client, system)
            # Jobs that have ended, at the limit of their time or by force, are asked for again.
            yield replace(_workers_of(client), replace_lost=lambda: replace_lost(cluster, count))


def job_cluster_class(system: str) -> Any:
    """Return the class of ``dask-jobqueue`` for one of :data:`JOB_SYSTEMS`."""
    return vars(import_module(f"dask_jobqueue.{system}"))[f"{_JOB_CLUSTERS[system]}Cluster"]


def job_interpreter(system: str) -> str:
    """Return how a job starts Python: as configured for the job system, and with the options of all our processes.

    The job runs ``-m distributed.cli.dask_worker`` in a folder of the job system's choice, most often the one that the
    batch was started in. The processes that it starts in turn get the same options from :mod:`multiprocessing`.
    """
    _, dask = _dask()
    return shell_interpreter(dask.config.get(f"jobqueue.{system}.python", None))


@contextmanager
def start_workers(
    scheduler: str | None = None,
    job_system: str | None = None,
    count: int | None = None,
    memory: str | None = None,
) -> Iterator[BatchWorkers]:
    """Use a running scheduler, else a job system, else this machine; errors as of these three."""
    if scheduler is not None:
        with scheduler_workers(scheduler) as found:
            yield found
    elif job_system is not None:
        with job_workers(job_system, count or 1) as found:
            yield found
    else:
        with local_workers(count, memory) as found:
            yield found


def _dask() -> tuple[Any, Any]:
    distributed = import_extra("distributed", purpose=_PURPOSE)
    return distributed, import_extra("dask", purpose=_PURPOSE)


def _quiet(distributed: Any) -> AbstractContextManager[None]:
    """Keep what Dask logs of lost connections, with a traceback each, off standard error; errors are raised besides."""
    quiet: AbstractContextManager[None] = distributed.utils.silence_logging_cmgr(logging.CRITICAL)
    return quiet


def _settings() -> dict[str, object]:
    return {
        # Of a scheduler on this machine. A group that ends a worker twice is divided, until the item is found.
        "distributed.scheduler.allowed-failures": 1,
        "distributed.nanny.pre-spawn-environ": _WORKER_VARIABLES,
        # What Dask watches many times a second, which takes several hundredths of a core in each process.
        "distributed.admin.tick.interval": "500ms",
        "distributed.worker.memory.monitor-interval": "500ms",
        "distributed.worker.profile.enabled": False,
        # A worker beyond its memory is replaced; what it holds is small, and is not written to the disk before.
        "distributed.worker.memory.target": False,
        "distributed.worker.memory.spill": False,
        "distributed.worker.memory.pause": False,
    }


def _wait_for_workers(client: Any, where: str) -> None:
    """Wait for the first worker; raise :class:`SuiteError` where none comes."""
    try:
        client.wait_for_workers(1, timeout=_WORKERS_S)
    except TimeoutError as error:
        raise SuiteError(f"{where}: no worker is there after {_WORKERS_S:g} s.") from error


def replace_lost(cluster: Any, count: int) -> None:
    """Have a cluster of Dask start workers again where it has fewer than ``count``; return at once.

    It starts a process in the place of one that died, but gives a worker up whose process takes long for that, as on a
    busy machine. To scale to the same number brings it back, and does nothing where all are there or begin.
    """

    def forget_ended() -> None:
        # Those that did not begin would count as there for ever.
        for name, worker in tuple(cluster.workers.items()):
            if worker.status.name in ("failed", "closed"):
                del cluster.workers[name]

    cluster.loop.add_callback(forget_ended)
    cluster.scale(count)


def _workers_of(client: Any) -> BatchWorkers:
    def reached() -> bool:
        return bool(client.status == "running")

    def width() -> int:
        # The scheduler is asked each time: workers of a cluster come and go.
        try:
            return sum(client.nthreads().values()) if reached() else 0
        except OSError:  # the connection was lost just now
            return 0

    return BatchWorkers(client.get_executor(pure=False), width, reached)
