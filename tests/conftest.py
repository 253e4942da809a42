"""Fixtures that every room's tests share."""

from __future__ import annotations

import errno
import gc
import importlib.util
import json
import os
import signal
import sys
from collections.abc import Callable, Iterator
from itertools import count
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from filelock import FileLock
from hypothesis import HealthCheck, settings
from pytestqt.qtbot import QtBot

# A shell that starts the tests in the background lets them ignore Ctrl-C, and all processes that they start too.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

CHECKOUT = Path(__file__).resolve().parent.parent
sys.path.append(str(CHECKOUT / "packaging" / "generators"))  # of the packaged meshes

# Neither has a limit of time: the speed of a machine decides no test. Runs that name no profile use "ci", which tries
# the same examples each time; "--hypothesis-profile=nightly" tries ten times as many, with new seeds, and prints how
# to repeat a failure. A slow test takes a share of "settings.default.max_examples", not a number of its own.
_untimed = settings(deadline=None, suppress_health_check=[HealthCheck.too_slow], print_blob=True)
settings.register_profile("ci", _untimed, max_examples=60, derandomize=True, database=None)
# Hypothesis derandomizes by default where the variable CI is set.
settings.register_profile("nightly", _untimed, max_examples=600, derandomize=False)
settings.load_profile("ci")


@pytest.hookimpl(tryfirst=True)
def pytest_collection() -> None:
    """Search for no garbage while thousands of tests are collected, which are none."""
    gc.disable()


@pytest.hookimpl(trylast=True)
def pytest_collection_finish() -> None:
    """Keep the collected tests out of every later search for garbage."""
    gc.collect()
    gc.freeze()
    gc.enable()


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """The folder of real files made by others; the test is skipped where there is none."""
    root = Path(os.environ.get("BRDF_SUITE_SHARED", CHECKOUT.parent / "shared"))
    if not (root / "data").is_dir():
        pytest.skip("no real files: set BRDF_SUITE_SHARED to the folder that holds data/")
    return root / "data"


PATIENCE_MS = 120_000
"""A wait ends a test that hangs; how fast this machine is, and what else runs on it, is no matter of a test."""


class PatientBot(QtBot):
    """Waits as long as it takes, whatever limit the call gives."""

    def waitUntil(self, callback, *, timeout=PATIENCE_MS):  # noqa: N802 - the name is Qt's
        # None would end the wait, as a callback's that asserts; what is not there yet is no such answer.
        return super().waitUntil(lambda: bool(callback()), timeout=max(timeout, PATIENCE_MS))

    def waitSignal(self, signal, *, timeout=PATIENCE_MS, raising=True, **more):  # noqa: N802 - the name is Qt's
        # Where its absence is no failure, as within assertNotEmitted, all of the time would be waited.
        limit = max(timeout, PATIENCE_MS) if raising else timeout
        return super().waitSignal(signal, timeout=limit, raising=raising, **more)

    def waitSignals(self, signals, *, timeout=PATIENCE_MS, **more):  # noqa: N802 - the name is Qt's
        return super().waitSignals(signals, timeout=max(timeout, PATIENCE_MS), **more)

    def waitExposed(self, widget, *, timeout=PATIENCE_MS):  # noqa: N802 - the name is Qt's
        return super().waitExposed(widget, timeout=max(timeout, PATIENCE_MS))

    def waitActive(self, widget, *, timeout=PATIENCE_MS):  # noqa: N802 - the name is Qt's
        return super().waitActive(widget, timeout=max(timeout, PATIENCE_MS))


@pytest.fixture
def qtbot(qapp, request: pytest.FixtureRequest) -> QtBot:
    """Drives widgets, with patience."""
    return PatientBot(request)


@pytest.fixture(scope="session")
def load_helper() -> Callable[[str], ModuleType]:
    """Return what loads a module beside this file by its file's name."""

    def load(name: str) -> ModuleType:
        spec = importlib.util.spec_from_file_location(
            name.removesuffix(".py"), Path(__file__).with_name(name)
        )
        module = importlib.util.module_from_spec(spec)
        sys.modules[spec.name] = module  # where its dataclasses look for it
        spec.loader.exec_module(module)
        return module

    return load


@pytest.fixture(scope="session")
def walks(qapp, load_helper: Callable[[str], ModuleType]) -> ModuleType:
    """Walks through all widgets of a program: see ``window_walks.py``."""
    return load_helper("window_walks.py")


@pytest.fixture(scope="session")
def press_profile(load_helper: Callable[[str], ModuleType]) -> ModuleType:
    """A press whose colours are known, and its ICC profile: see ``press_profile.py``."""
    return load_helper("press_profile.py")


@pytest.fixture(scope="session")
def caches(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """Return names of folders, a new one each time, that are made when something is written there."""
    folder = tmp_path_factory.mktemp("own caches")
    return (folder / str(number) for number in count())


@pytest.fixture(autouse=True)
def own_cache(caches: Iterator[Path], monkeypatch: pytest.MonkeyPatch) -> None:
    """No test reads or writes the user's cache. (A ``tmp_path`` for each test takes milliseconds to make.)"""
    monkeypatch.setenv("BRDF_SUITE_CACHE", str(next(caches)))


@pytest.fixture
def full_disk(monkeypatch: pytest.MonkeyPatch) -> None:
    """The disk is full when a file that was written is to take the place of the old one."""

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "replace", full)


@pytest.fixture(scope="session")
def cache_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of :func:`shared_cache`: one for all workers, which take turns as programs do."""
    given = os.environ.get("BRDF_SUITE_TESTS_CACHE")
    if given:
        return Path(given)
    own = tmp_path_factory.getbasetemp()
    folder = (own.parent if "PYTEST_XDIST_WORKER" in os.environ else own) / "cache of all tests"
    folder.mkdir(exist_ok=True)
    return folder


@pytest.fixture
def shared_cache(own_cache: None, cache_folder: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """One cache for all tests that ask for it: each light is filtered and each surface baked once a run."""
    monkeypatch.setenv("BRDF_SUITE_CACHE", str(cache_folder))
    return cache_folder


@pytest.fixture(scope="session")
def materials(cache_folder: Path, load_helper: Callable[[str], ModuleType]) -> dict[str, str]:
    """A name or file of every kind of material, by kind: made once for all workers, which only read them."""
    folder = cache_folder / "tests" / "materials"
    folder.mkdir(parents=True, exist_ok=True)
    listed = folder / "kinds.json"
    with FileLock(f"{listed}.lock"):
        if not listed.exists():
            listed.write_text(json.dumps(load_helper("materials.py").make_materials(folder)))
    found: dict[str, str] = json.loads(listed.read_text())
    return found


@pytest.fixture(scope="session")
def checkout() -> Path:
    """The top of the source tree."""
    return CHECKOUT


@pytest.fixture(scope="session")
def chi_square() -> Callable[..., float]:
    """Return the test of drawn directions against a density, which gives a p-value."""
    return _chi_square


def _chi_square(
    drawn: np.ndarray,
    density: Callable[[np.ndarray], np.ndarray],
    peak_theta: float = 0.0,
    parts: int = 1,
) -> float:
    """Return the probability of a worse fit by chance of ``drawn`` (n, 3) to ``density`` (per solid angle).

    Pearson's test on cells in polar angle and azimuth above the horizon, and one cell for all that is lost below
    it. Cell edges are quantiles of the first tenth of the directions, which the test then leaves out. The density
    is integrated by Gauss-Legendre points on panels that narrow towards ``peak_theta`` on the +x side, where a
    mirror lobe may be, and are cut into ``parts`` along the polar angle where
    the density has kinks there, as a tabulated one has. Cells that expect
    fewer than 5 are pooled.
    """
    from scipy.special import gammaincc

    pilot, drawn = drawn[: len(drawn) // 10], drawn[len(drawn) // 10 :]
    pilot = pilot[pilot[:, 2] > 0.0]
    near = 1e-4 * 2.0 ** np.arange(16)
    levels = np.linspace(0.0, 1.0, 61)
    edges, fine = [], []
    for values, low, high, peak, cut in (
        (np.arccos(np.clip(pilot[:, 2], 0.0, 1.0)), 0.0, 0.5 * np.pi, peak_theta, parts),
        (np.arctan2(pilot[:, 1], pilot[:, 0]), -np.pi, np.pi, 0.0, 1),
    ):
        quantiles = np.quantile(values, levels)
        quantiles[0], quantiles[-1] = low, high
        panels = np.concatenate((quantiles, [peak], peak - near, peak + near))
        panels = np.unique(panels[(panels >= low) & (panels <= high)])
        steps = np.arange((len(panels) - 1) * cut + 1) / cut
        fine.append(np.interp(steps, np.arange(len(panels)), panels))
        edges.append(np.unique(quantiles[::4]))
    (theta_edges, phi_edges), (theta_fine, phi_fine) = edges, fine
    # Where kinks ask for narrow panels, two points in each are as exact as four in wide ones.
    nodes, shares = np.polynomial.legendre.leggauss(4 if parts == 1 else 2)

    def points(panel_edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        centre, reach = 0.5 * (panel_edges[1:] + panel_edges[:-1]), 0.5 * np.diff(panel_edges)
        return (centre[:, None] + reach[:, None] * nodes).ravel(), (reach[:, None] * shares).ravel()

    (theta, w_theta), (phi, w_phi) = points(theta_fine), points(phi_fine)
    t, p = np.meshgrid(theta, phi, indexing="ij")
    directions = np.stack((np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)), axis=-1)
    mass = density(directions.reshape(-1, 3)).reshape(t.shape) * np.sin(t) * w_theta[:, None] * w_phi
    # Every cell's edge is a panel's: the points of a cell are a block of the grid.
    expected = np.add.reduceat(mass, np.searchsorted(theta, theta_edges[:-1]), axis=0)
    expected = np.add.reduceat(expected, np.searchsorted(phi, phi_edges[:-1]), axis=1)
    kept = drawn[drawn[:, 2] > 0.0]
    angles = np.arccos(np.clip(kept[:, 2], 0.0, 1.0)), np.arctan2(kept[:, 1], kept[:, 0])
    found, *_ = np.histogram2d(*angles, bins=[theta_edges, phi_edges])
    assert found.sum() == len(kept)
    wanted = np.append(expected.ravel() * len(drawn), len(drawn) * (1.0 - expected.sum()))
    counted = np.append(found.ravel(), len(drawn) - len(kept))
    assert wanted[-1] > -1e-3 * len(drawn), "the density holds more than 1"
    few = wanted < 5.0
    pooled, seen = max(float(wanted[few].sum()), 0.0), float(counted[few].sum())
    wanted, counted = wanted[~few], counted[~few]
    if pooled >= 5.0:
        wanted, counted = np.append(wanted, pooled), np.append(counted, seen)
    else:
        assert seen < 25.0, "directions were drawn where the density is next to nothing"
    statistic = float(np.sum((counted - wanted) ** 2 / wanted))
    return float(gammaincc(0.5 * (len(wanted) - 1), 0.5 * statistic))
