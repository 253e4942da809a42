"""Batches on processes: a scheduler and workers as a cluster has them, which are killed on the way."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any, ClassVar

import cloudpickle
import pytest

from brdf_suite.batches.items import BatchItem, list_paints
from brdf_suite.batches.running import run_batch
from brdf_suite.batches.steps import Outcome, Work
from brdf_suite.batches.workers import (
    JOB_SYSTEMS,
    BatchWorkers,
    job_cluster_class,
    job_interpreter,
    job_workers,
    local_workers,
    scheduler_workers,
)
from brdf_suite.cli.main import main
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.processes import child_command
from brdf_suite.progress import Progress

PAINTS = 60


@pytest.fixture(scope="session")
def clusters(load_helper: Callable[[str], ModuleType]) -> ModuleType:
    return load_helper("killed_cluster.py")


@pytest.fixture
def cluster(clusters: ModuleType, tmp_path: Path) -> Iterator[Any]:
    with clusters.cluster_of_two(tmp_path) as made:
        yield made


@pytest.fixture
def palette(clusters: ModuleType, tmp_path: Path) -> Path:
    path: Path = clusters.make_palette(tmp_path / "fleet.brdfpalette", PAINTS)
    return path


def test_a_batch_survives_the_kill_of_a_worker_and_then_of_the_scheduler(
    clusters: ModuleType, cluster: Any, palette: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    status, problem = clusters.kill_worker_and_scheduler(cluster, palette, out)
    assert status == 1
    assert "goes on where it was" in problem
    assert "Traceback" not in problem
    before = len(clusters.lines_of(out))
    assert 15 <= before < PAINTS

    answer = clusters.run_again(cluster, palette, out)
    assert (answer["items"], answer["done_before"], answer["done"]) == (PAINTS, before, PAINTS - before)
    keys = [line["key"] for line in clusters.lines_of(out)]
    assert len(keys) == len({*keys}) == PAINTS
    assert (out / "results.csv").read_text(encoding="utf-8").count("\n") == PAINTS + 1


def test_a_killed_command_goes_on(clusters: ModuleType, cluster: Any, palette: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    first = clusters.start_batch(palette, out, cluster.address)
    clusters.wait_until(lambda: len(clusters.lines_of(out)) >= 5)
    first.kill()
    first.communicate()
    answer = clusters.finish(clusters.start_batch(palette, out, cluster.address))
    assert answer["done_before"] >= 5
    assert len({line["key"] for line in clusters.lines_of(out)}) == PAINTS


def test_a_worker_that_does_not_see_the_folder_says_so(
    clusters: ModuleType, cluster: Any, tmp_path: Path
) -> None:
    from brdf_suite.batches.steps import Measure
    from brdf_suite.batches.worker import do_items
    from brdf_suite.release import __version__

    with scheduler_workers(cluster.address) as workers:
        asked = workers.executor.submit(do_items, Measure(), "", [], str(tmp_path / "nowhere"), __version__)
        with pytest.raises(SuiteError, match="does not see"):
            asked.result(clusters.PATIENCE_S)
        older = workers.executor.submit(do_items, Measure(), "", [], str(tmp_path), "0.0.1")
        with pytest.raises(SuiteError, match=r"the batch is of 0\.0\.1"):
            older.result(clusters.PATIENCE_S)


def test_a_step_that_a_worker_cannot_begin_ends_the_batch_with_its_reason(
    clusters: ModuleType, cluster: Any, tmp_path: Path
) -> None:
    @dataclass(frozen=True)
    class NoLight:
        name: ClassVar[str] = "no light"

        def prepare(self, _progress: Progress | None) -> None:
            """There is nothing to prepare."""

        def open(self) -> AbstractContextManager[Work]:
            raise FileError("/home/me/sky.hdr", "there is no such file")

    with pytest.raises(FileError, match=r"/home/me/sky\.hdr: there is no such file"):
        run_batch(
            NoLight(), list_paints(["blue", "red"]), tmp_path, lambda: scheduler_workers(cluster.address)
        )
    assert clusters.lines_of(tmp_path) == []


@pytest.mark.parametrize("address", ["tls://x:1", "tcp://localhost:abc"])
def test_no_scheduler_is_one_line(address: str, tmp_path: Path) -> None:
    words = ("batch", "measure", "blue", "-o", str(tmp_path), "--scheduler", address)
    done = subprocess.run(child_command("brdf_suite", *words), capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1].startswith(f"brdf-suite: No scheduler answers at {address}: ")
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("address", ["foo", "", "http://localhost:8786", "tcp://"])
def test_what_is_no_address_is_refused_at_once(address: str) -> None:
    with (
        pytest.raises(SuiteError, match=f"'{address}' is no address of a scheduler; expected tcp"),
        scheduler_workers(address),
    ):
        pass


@pytest.mark.parametrize("system", JOB_SYSTEMS)
def test_a_job_system_that_is_not_configured_says_so(system: str, tmp_path: Path) -> None:
    words = ("batch", "measure", "blue", "-o", str(tmp_path), "--jobs", system)
    done = subprocess.run(child_command("brdf_suite", *words), capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert "Traceback" not in done.stderr
    assert done.stderr.splitlines()[-1].startswith(
        f"brdf-suite: {system}: cores and memory of a job are not set; see the section jobqueue: {system}:"
    )
    assert done.stderr.endswith("jobqueue.yaml.\n")


def test_a_script_without_its_guard_says_what_is_missing(tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(
        "import brdf_suite as bs\nbs.batch('measure', 'blue', 'out', workers=1)\n", encoding="utf-8"
    )
    done = subprocess.run(
        [sys.executable, str(script)], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 1
    assert "SuiteError: The workers do not start" in done.stderr
    assert "A script starts its batch below" in done.stderr.splitlines()[-1]


@pytest.mark.skipif(not hasattr(os, "killpg"), reason="there are no process groups")
def test_ctrl_c_in_a_terminal_ends_in_one_line(clusters: ModuleType, palette: Path, tmp_path: Path) -> None:
    words = ("batch", "measure", str(palette), "-o", str(tmp_path / "out"), "--workers", "2", "--group", "1")
    running = subprocess.Popen(
        child_command("brdf_suite", *words),
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    clusters.wait_until(lambda: len(clusters.lines_of(tmp_path / "out")) >= 3)
    os.killpg(running.pid, signal.SIGINT)  # as a terminal does: to the workers too
    _, said = running.communicate(timeout=clusters.PATIENCE_S)
    assert running.returncode == 130
    assert "Traceback" not in said
    assert said.splitlines()[-1] == "brdf-suite: cancelled"


def test_problems_are_printed_where_only_results_and_errors_are_wanted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    missing = [f"none {number}" for number in range(23)]
    line = ["batch", "measure", "blue", "blue", *missing, "-o", str(tmp_path / "out"), "--workers", "1", "-q"]
    assert main(line) == 1
    shown = capsys.readouterr()
    lines = shown.err.splitlines()
    assert lines[0].startswith("problem: none 0: ")
    assert lines[20:] == ["problem: 3 more, all in results.csv"]
    assert shown.out == ""


def test_a_worker_has_one_thread_and_keeps_the_memory_of_arrays(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OPENBLAS_NUM_THREADS", "2")
    monkeypatch.setenv("MALLOC_TRIM_THRESHOLD_", "65536")
    monkeypatch.delenv("LP_NUM_THREADS", raising=False)
    before = dict(os.environ)
    wanted = {
        "LP_NUM_THREADS": "1",
        "OPENBLAS_NUM_THREADS": "1",
        "MALLOC_MMAP_THRESHOLD_": str(32 << 20),
        "MALLOC_TRIM_THRESHOLD_": str(16 << 20),
    }
    with local_workers(1) as workers:
        assert {name: workers.executor.submit(os.getenv, name).result() for name in wanted} == wanted
    assert dict(os.environ) == before


def test_memory_is_written_with_its_unit() -> None:
    with pytest.raises(SuiteError, match="no amount of memory"), local_workers(1, "much"):
        pass


@pytest.mark.parametrize("memory", ["100MB", "0", "-2GB"])
def test_memory_in_which_no_worker_can_begin_is_refused(memory: str) -> None:
    with (
        pytest.raises(SuiteError, match=f"'{memory}' is too little memory for a worker; it takes"),
        local_workers(1, memory),
    ):
        pass


@pytest.mark.skipif(not hasattr(signal, "pthread_kill"), reason="signals reach no thread of choice")
def test_an_interrupt_while_workers_start_ends_them(monkeypatch: pytest.MonkeyPatch) -> None:
    """The system may give it to any thread that was there before; Python then interrupts the main one."""
    import distributed

    begin, started = distributed.LocalCluster, []
    done = threading.Event()
    other = threading.Thread(target=done.wait)
    other.start()

    def interrupted(**settings: Any) -> Any:
        assert other.ident is not None
        signal.pthread_kill(other.ident, signal.SIGINT)
        started.append(begin(**settings))
        return started[0]

    monkeypatch.setattr(distributed, "LocalCluster", interrupted)
    try:
        with pytest.raises(KeyboardInterrupt), local_workers(1):
            pytest.fail("the interrupt was lost")
    finally:
        done.set()
        other.join()
    assert started[0].status.name == "closed"


@dataclass(frozen=True)
class Deadly:
    """One of its items ends the process."""

    name: ClassVar[str] = "deadly"

    def prepare(self, _progress: Progress | None) -> None:
        """There is nothing to prepare."""

    def open(self) -> AbstractContextManager[Work]:
        def work(item: BatchItem, _folder: Path) -> Outcome:
            if item.label == "red":
                os.kill(os.getpid(), signal.SIGKILL)
            return Outcome({"name": item.label})

        return nullcontext(work)


@pytest.mark.parametrize("given_up_after", ["15s", "1ms"])
def test_an_item_that_kills_its_worker_is_reported_and_the_rest_done(
    given_up_after: str, tmp_path: Path
) -> None:
    """Also where Dask gives a worker up before its new process has begun, as it does on a busy machine."""
    import dask
    import distributed  # noqa: F401 - its settings are set from then on

    cloudpickle.register_pickle_by_value(sys.modules[__name__])
    try:
        names = ["blue", "copper", "red", "fine_silver"]
        with dask.config.set({"distributed.deploy.lost-worker-timeout": given_up_after}):
            done = run_batch(Deadly(), list_paints(names), tmp_path, lambda: local_workers(1), group=4)
    finally:
        cloudpickle.unregister_pickle_by_value(sys.modules[__name__])
    ((source, problem),) = done.problems
    assert source == "red"
    assert "the process that worked on it ended" in problem


def pid_of_worker(workers: BatchWorkers, ask: Callable[[], int] = os.getpid) -> int:
    """Return the process number of the only worker, or of what started it."""
    found: int = workers.executor.submit(ask).result()
    return found


def wait_for_another(clusters: ModuleType, workers: BatchWorkers) -> None:
    """Look, as a batch does, until the only worker is there again."""

    def look() -> bool:
        workers.replace_lost()
        return workers.width() == 1

    clusters.wait_until(look)


def test_a_worker_whose_new_processes_fail_is_started_again(clusters: ModuleType, tmp_path: Path) -> None:
    import dask
    import distributed  # noqa: F401 - its settings are set from then on

    broken, failures = tmp_path / "broken", tmp_path / "failures"
    script = tmp_path / "begin.py"
    script.write_text(
        f"import os\nif os.path.exists({str(broken)!r}):\n"
        f"    print('failed', file=open({str(failures)!r}, 'a'))\n    os._exit(1)\n"
    )
    settings = {"distributed.worker.preload": [str(script)], "distributed.deploy.lost-worker-timeout": "1ms"}
    with dask.config.set(settings), local_workers(1) as workers:
        first = pid_of_worker(workers)
        broken.touch()
        os.kill(first, signal.SIGKILL)

        def fails_again() -> bool:
            workers.replace_lost()
            return failures.exists() and len(failures.read_text().splitlines()) >= 3

        clusters.wait_until(fails_again)
        assert workers.width() == 0
        broken.unlink()
        wait_for_another(clusters, workers)
        assert pid_of_worker(workers) != first


@pytest.fixture
def planted(tmp_path: Path) -> Path:
    """Return a folder of Python files that Python, Dask or the suite import by these names; each leaves ``ran``."""
    folder = tmp_path / "planted"
    folder.mkdir()
    for name in (
        "random",
        "json",
        "multiprocessing",
        "dask",
        "distributed",
        "numpy",
        "brdf_suite",
        "sitecustomize",
    ):
        (folder / f"{name}.py").write_text(f"open({str(tmp_path / 'ran')!r}, 'w').close()", encoding="utf-8")
    return folder


def measure_blue(folder: Path, variables: dict[str, str], *words: str) -> subprocess.CompletedProcess[str]:
    """Run a batch of one paint in a folder, without the variable that alone would keep its files out."""
    kept = {name: value for name, value in os.environ.items() if name != "PYTHONSAFEPATH"}
    return subprocess.run(
        child_command("brdf_suite", "batch", "measure", "blue", "-o", "out", *words),
        cwd=folder,
        env=kept | variables,
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )


def test_planted_modules_are_not_imported_by_workers(planted: Path) -> None:
    done = measure_blue(planted, {}, "--workers", "1")
    assert done.returncode == 0, done.stderr
    assert not (planted.parent / "ran").exists()
    assert (planted / "out" / "results.csv").is_file()


SUBMIT = """#!/bin/bash
cp "$1" "{folder}/job.sh"
bash "{folder}/job.sh" >"{folder}/job.log" 2>&1 &
echo "Submitted batch job $!"
"""


@pytest.fixture
def commands(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder with the commands of a job system that starts each job at once."""
    folder = tmp_path / "commands"
    folder.mkdir()
    for name, text in (
        ("sbatch", SUBMIT.format(folder=folder)),
        ("scancel", '#!/bin/bash\nkill "$1"\nexit 0\n'),
    ):
        (folder / name).write_text(text, encoding="utf-8")
        (folder / name).chmod(0o755)
    monkeypatch.setenv("PATH", f"{folder}{os.pathsep}{os.environ['PATH']}")
    return folder


def test_a_job_that_has_ended_is_asked_for_again(clusters: ModuleType, commands: Path) -> None:
    import dask
    import distributed  # noqa: F401 - its settings are set from then on

    settings = {
        "jobqueue.slurm.cores": 1,
        "jobqueue.slurm.memory": "4GB",
        "jobqueue.slurm.interface": "lo",
        "distributed.deploy.lost-worker-timeout": "1ms",
    }
    import_module("dask_jobqueue")  # as above
    with dask.config.set(settings), job_workers("slurm", 1) as workers:
        first = pid_of_worker(workers, os.getppid)
        os.kill(first, signal.SIGKILL)
        clusters.wait_until(lambda: workers.width() == 0)
        wait_for_another(clusters, workers)
        assert pid_of_worker(workers, os.getppid) != first
    assert (commands / "job.sh").is_file()


def test_planted_modules_are_not_imported_by_jobs(planted: Path, commands: Path) -> None:
    variables = {
        "DASK_JOBQUEUE__SLURM__CORES": "1",
        "DASK_JOBQUEUE__SLURM__MEMORY": "4GB",
        "DASK_JOBQUEUE__SLURM__INTERFACE": "lo",
    }
    done = measure_blue(planted, variables, "--jobs", "slurm", "--workers", "1")
    assert done.returncode == 0, done.stderr + (commands / "job.log").read_text(encoding="utf-8")
    assert "-m distributed.cli.dask_worker" in (commands / "job.sh").read_text(encoding="utf-8")
    assert not (planted.parent / "ran").exists()
    assert (planted / "out" / "results.csv").is_file()


@pytest.mark.parametrize("configured", [None, "container run python3"])
@pytest.mark.parametrize("system", JOB_SYSTEMS)
def test_every_job_script_starts_python_without_the_working_folder(
    system: str, configured: str | None
) -> None:
    dask = pytest.importorskip("dask")
    job = job_cluster_class(system).job_cls
    with dask.config.set({f"jobqueue.{system}.python": configured}):
        needed = {"htcondor": {"disk": "1GB"}, "oar": {"memory_per_core_property_name": "not_applicable"}}
        more = needed.get(system, {})
        made = job("tcp://host:1", "name", cores=1, memory="1GB", python=job_interpreter(system), **more)
    (line,) = [line for line in made.job_script().splitlines() if "distributed.cli.dask_worker" in line]
    start = configured or sys.executable
    assert f"{start} " in line
    assert " -P" in line.partition(start)[2].partition(" -m distributed.cli.dask_worker")[0]
