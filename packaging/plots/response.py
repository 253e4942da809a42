"""Draw the recovered response of the simulated camera, its error, and the noise of merged radiances.

    python packaging/plots/response.py [FOLDER]

The picture goes to docs/images. Everything is measured while it is drawn, in about a minute.
"""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot as plt

from brdf_suite.acquisition.radiance.merge import GOOD, merge
from brdf_suite.acquisition.radiance.sensor_maps import black_codes, dark_model
from brdf_suite.acquisition.response.fit import calibrate_response
from brdf_suite.acquisition.response.samples import ResponseSamples, spread
from brdf_suite.acquisition.simulator import Simulator, SimulatorSettings
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1

ROOT = Path(__file__).resolve().parents[2]
IMAGES = ROOT / "docs" / "images"
SIZE_INCHES = (12.0, 3.6)
DPI = 110
CHANNELS = (("red", "tab:red"), ("green", "tab:green"), ("blue", "tab:blue"))
PAINT = "table1_polaris_silver"


def draw(folder: Path) -> Path:
    """Write the picture into ``folder`` and return its path."""
    parts = _parts()
    folder.mkdir(parents=True, exist_ok=True)
    figure, axes = plt.subplots(1, 3, figsize=SIZE_INCHES, layout="constrained")
    found = parts.recovered(12)
    _curve(axes[0], found)
    _error(axes[1], found, parts)
    _noise(axes[2])
    path = folder / "acquisition_response.png"
    # No date inside: the same measurement gives the same bytes.
    figure.savefig(path, dpi=DPI, metadata={"Software": None})
    plt.close(figure)
    return path


def _parts() -> ModuleType:
    """Return the module of the benchmark whose cases are drawn."""
    path = ROOT / "tests" / "benchmarks" / "parts" / "acquisition" / "acquisition_response.py"
    spec = importlib.util.spec_from_file_location("acquisition_response", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def _curve(axes: plt.Axes, found) -> None:
    codes = np.arange(found.truth.shape[1])
    for c, (name, colour) in enumerate(CHANNELS):
        axes.plot(codes, found.fit.response.exposure[c], color=colour, label=name)
        axes.plot(codes, found.truth[c], "k--", lw=0.8, label="true" if c == 2 else None)
    axes.set_xlabel("code, 12 bit")
    axes.set_ylabel("exposure (0.5 at the middle code)")
    axes.legend()
    axes.grid(alpha=0.3)
    axes.set_title("Response of the camera")


def _error(axes: plt.Axes, found, parts: ModuleType) -> None:
    scale = found.truth.shape[1] - 1 - found.black
    run = slice(int(found.black + parts.LOW * scale), int(found.black + parts.HIGH * scale))
    codes = np.arange(found.truth.shape[1])[run]
    turns = parts.by_turns(found.samples)
    for c, (_, colour) in enumerate(CHANNELS):
        apart = 100.0 * np.log(turns[c, run] / found.truth[c, run])
        axes.plot(codes, apart, color=colour, lw=0.4, alpha=0.35, label="by turns" if c == 2 else None)
    for c, (name, colour) in enumerate(CHANNELS):
        apart = 100.0 * np.log(found.fit.response.exposure[c, run] / found.truth[c, run])
        axes.plot(codes, apart, color=colour, label=name)
    axes.set_ylim(-1.5, 1.5)
    axes.set_xlabel("code, 12 bit")
    axes.set_ylabel("error of the exposure, %")
    axes.legend(ncols=2)
    axes.grid(alpha=0.3)
    axes.set_title("Its error, and by turns (faint)")


def _noise(axes: plt.Axes) -> None:
    settings = SimulatorSettings(size=(400, 400), gain_spread=0.0, vignetting=0.0)
    rig = Simulator(CookTorrance(TABLE_1[PAINT]), settings, PAINT)
    times = settings.exposures_s()
    samples = ResponseSamples(times, 12)
    for k in spread(180, 6):
        samples.add(rig.position(k))
    dark_stack = rig.dark()
    response = calibrate_response(samples, black_codes(dark_stack)).response
    dark = dark_model(dark_stack, times, response)
    edges = np.geomspace(1e-3, 2e3, 25)
    sums = np.zeros((3, len(edges) - 1))
    for k in (20, 60, 100, 140):
        merged = merge(rig.position(k), times, response, dark=dark)
        truth = rig.radiance(k)
        chosen = (merged.state == GOOD) & (truth > 0.0)
        bins = np.digitize(truth[chosen], edges) - 1
        inside = (bins >= 0) & (bins < sums.shape[1])
        relative = (merged.radiance[chosen] / truth[chosen] - 1.0) ** 2
        stated = merged.variance[chosen] / truth[chosen] ** 2
        for row, values in enumerate((relative, stated, np.ones_like(stated))):
            sums[row] += np.bincount(bins[inside], values[inside], minlength=sums.shape[1])[: sums.shape[1]]
    full = sums[2] > 100
    middle = np.sqrt(edges[1:] * edges[:-1])[full]
    axes.loglog(middle, 100.0 * np.sqrt(sums[0] / np.maximum(sums[2], 1))[full], "o", ms=4, label="measured")
    axes.loglog(middle, 100.0 * np.sqrt(sums[1] / np.maximum(sums[2], 1))[full], "k-", lw=1, label="stated")
    axes.set_xlabel("radiance, photographs' unit per second")
    axes.set_ylabel("standard error, %")
    axes.legend()
    axes.grid(alpha=0.3)
    axes.set_title("Noise of one merged pixel")


def main() -> int:
    """Draw into the folder that the command line names."""
    print(draw(Path(sys.argv[1]) if len(sys.argv) > 1 else IMAGES))
    return 0


if __name__ == "__main__":
    sys.exit(main())
