"""Draw docs/images/factorization_*.png: Figures 1, 2, 4 and 5 of McCool, Ang and Ahmad 2001 with our data, and fits.

    python packaging/plots/factorization.py [--shared FOLDER]

Of FOLDER (default: ../shared beside the checkout) cayman and krylon blue are read; where they are not at hand, what
shows them is left out.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

import matplotlib as mpl

from brdf_suite.arrays import Floats

mpl.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE, WORKING_TO_SRGB, srgb_encode
from brdf_suite.fitting.homomorphic.reflectance_fit import FactoringOptions, factor_reflectance
from brdf_suite.fitting.homomorphic.samples import sample_reflectance
from brdf_suite.geometry import warps
from brdf_suite.geometry.directions import spherical
from brdf_suite.inspection.factor_pictures import factor_pictures
from brdf_suite.pipeline.material import load_material
from brdf_suite.reflectance.models.poulin_fournier import PoulinFournier
from brdf_suite.reflectance.protocol import Reflectance
from tools.evaluation.picture_factors import factor_picture

ROOT = Path(__file__).resolve().parents[2]
IMAGES = ROOT / "docs" / "images"
SATIN = PoulinFournier(kd=(0.05, 0.06, 0.09), ks=(0.6, 0.55, 0.5), exponent=40.0, spacing=2.0, floor=0.2)
PAINTS = ("table1_polaris_silver", "blue_metallic")
MEASURED = ("krylon_blue", "cayman")
SIZE = 200
LIGHTS = ((-0.5, 0.6, 0.62), (0.75, 0.25, 0.6), (0.05, -0.7, 0.7))


@dataclass(frozen=True, eq=False)
class Material:
    """Something that reflects, beside its factorization."""

    name: str
    truth: Reflectance
    factored: Reflectance


def main() -> None:
    """Factor and draw."""
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--shared", type=Path, default=ROOT.parent / "shared")
    shared = arguments.parse_args().shared
    materials = gather(shared)
    figure_1(materials)
    figure_2()
    figure_4(materials)
    figure_5(materials[0])
    measured(shared)


def gather(shared: Path) -> list[Material]:
    """Return satin, the measured files, and two paints."""
    options = FactoringOptions(factors="p:wo q:h p:wi", peak="off")
    found = [Material("satin, anisotropic", SATIN, factor_reflectance("satin", SATIN, options).value)]
    names = [*(shared / "data" / "brdf" / f"{name}.brdf" for name in MEASURED), *PAINTS]
    for name in names:
        if isinstance(name, Path) and not name.is_file():
            print(f"{name} is not there; left out")
            continue
        item = load_material(name)
        fit = factor_reflectance(item.name, item.reflectance)
        title = name.stem if isinstance(name, Path) else item.name
        found.append(Material(title.replace("_", " ").lower(), item.reflectance, fit.value))
    return found


def ball(reflectance: Reflectance) -> Floats:
    """Return the radiance (SIZE, SIZE, 3) of a ball from far in front of it, brushed around the upright axis."""
    along = (np.arange(SIZE) + 0.5) / SIZE * 2.1 - 1.05
    x, y = np.meshgrid(along, -along)
    inside = x * x + y * y < 1.0
    n = np.stack((x, y, np.sqrt(np.maximum(1.0 - x * x - y * y, 0.0))), axis=-1)[inside]
    tangent = np.cross(np.array([0.0, 1.0, 0.0]), n)
    tangent /= np.maximum(np.linalg.norm(tangent, axis=1, keepdims=True), 1e-9)
    frame = np.stack((tangent, np.cross(n, tangent), n), axis=1)
    view = frame[:, :, 2]
    total = np.zeros((len(n), 3))
    for light in LIGHTS:
        local = frame @ (np.asarray(light) / np.linalg.norm(light))
        total += reflectance.eval(local, view) * np.maximum(local[:, 2:], 0.0)
    picture = np.zeros((SIZE, SIZE, 3))
    picture[inside] = total
    return picture


def shown(radiance: Floats, white: float) -> Floats:
    """Return sRGB (…, 3), 0…1, with a soft shoulder above half of ``white``."""
    rgb = np.maximum(radiance @ WORKING_TO_SRGB.T, 0.0) / white
    rgb = np.where(rgb > 0.5, 1.0 - 0.25 / np.maximum(rgb, 0.5), rgb)
    return srgb_encode(np.clip(rgb, 0.0, 1.0))


def white_of(picture: Floats) -> float:
    """Return three times what nine tenths of the lit ball stay below."""
    grey = picture @ LUMINANCE
    return 3.0 * float(np.quantile(grey[grey > 0.0], 0.9))


def bare(axes) -> None:
    """Take frame and ticks away."""
    axes.set_xticks([])
    axes.set_yticks([])
    for side in axes.spines.values():
        side.set_visible(False)


def figure_1(materials: list[Material]) -> None:
    """Every material under three lamps: directly evaluated, and factored."""
    figure, axes = plt.subplots(2, len(materials), figsize=(2.1 * len(materials), 4.4), squeeze=False)
    for column, material in enumerate(materials):
        pictures = ball(material.truth), ball(material.factored)
        white = white_of(pictures[0])
        for row, picture in enumerate(pictures):
            axes[row, column].imshow(shown(picture, white))
            bare(axes[row, column])
        axes[0, column].set_title(material.name, fontsize=9)
    for row, title in enumerate(("as it is", "factored")):
        axes[row, 0].set_ylabel(title, fontsize=9)
    save(figure, "factorization_figure_1.png")


def noise(size: int = 128, cells: int = 6) -> Floats:
    """Return Perlin's gradient noise of three octaves, over 0."""
    rng = np.random.default_rng(4)
    total = np.zeros((size, size))
    for octave in (1, 2, 4):
        count = cells * octave // 2
        turn = rng.uniform(0.0, 2.0 * np.pi, (count + 1, count + 1))
        slope = np.stack((np.cos(turn), np.sin(turn)), axis=-1)
        at = (np.arange(size) + 0.5) / size * count
        low, share = at.astype(int), at - at.astype(int)
        ease = share**3 * (share * (6.0 * share - 15.0) + 10.0)

        def corner(row: int, column: int, slope=slope, low=low, share=share) -> Floats:
            g = slope[low[:, None] + row, low[None, :] + column]
            return g[..., 0] * (share[None, :] - column) + g[..., 1] * (share[:, None] - row)

        top = corner(0, 0) + ease[None, :] * (corner(0, 1) - corner(0, 0))
        foot = corner(1, 0) + ease[None, :] * (corner(1, 1) - corner(1, 0))
        total += (top + ease[:, None] * (foot - top)) / octave
    return 0.5 + 0.45 * total / np.abs(total).max()


def figure_2() -> None:
    """A picture, and its products of two and of three functions of one variable."""
    picture = noise()
    figure, axes = plt.subplots(1, 4, figsize=(11.0, 2.9))
    shows = [("input, Perlin noise", picture)]
    for words, title in ((("x", "y"), "p(x) p(y)"), (("x", "y", "x-y"), "p(x) p(y) p(x − y)")):
        found, factors = factor_picture(picture, words)
        snr = 10.0 * np.log10((picture**2).mean() / ((picture - found) ** 2).mean())
        shows.append((f"{title}: SNR {snr:.1f} dB", found))
    for place, (title, values) in enumerate(shows):
        axes[place].imshow(values, cmap="gray", vmin=0.0, vmax=1.0)
        axes[place].set_title(title, fontsize=9)
        bare(axes[place])
    for name, values in factors.items():
        axes[3].plot(
            (np.arange(len(values)) + 0.5) / len(values), values / np.exp(np.log(values).mean()), label=name
        )
    axes[3].set_title("the three factors, over their mean", fontsize=9)
    axes[3].set_yscale("log")
    axes[3].legend(fontsize=8)
    axes[3].tick_params(labelsize=7)
    save(figure, "factorization_figure_2.png")


def figure_4(materials: list[Material]) -> None:
    """The maps of each material over their largest values, and α as a colour."""
    columns = 1 + max(len(factor_pictures(one.factored)) for one in materials)
    figure, axes = plt.subplots(len(materials), columns, figsize=(1.55 * columns, 1.7 * len(materials)))
    for row, material in enumerate(materials):
        for axis in axes[row]:
            bare(axis)
        axes[row, 0].set_ylabel(material.name, fontsize=8)
        pictures = factor_pictures(material.factored)
        for column, one in enumerate(pictures):
            # Cube roots: what is a hundredth is seen.
            rgb = np.clip(one.values @ WORKING_TO_SRGB.T, 0.0, 1.0) ** (1.0 / 3.0)
            rgb[one.outside] = 1.0
            axes[row, column].imshow(rgb)
            reads = "".join(f"{one.name}({read}) " for read in one.reads)
            axes[row, column].set_title(reads + ("(peak)" if one.part == "peak" else ""), fontsize=6.5)
        alpha = np.asarray(material.factored.terms[0][0])
        rgb = np.clip((alpha / alpha.max()) @ WORKING_TO_SRGB.T, 0.0, 1.0) ** (1.0 / 3.0)
        axes[row, columns - 1].imshow(np.broadcast_to(rgb, (8, 8, 3)))
        axes[row, columns - 1].set_title("α", fontsize=7)
    save(figure, "factorization_figure_4.png")


def figure_5(satin: Material) -> None:
    """The anisotropic model and its factorization from the same lamps, and the difference."""
    truth, found = ball(satin.truth), ball(satin.factored)
    white = white_of(truth)
    figure, axes = plt.subplots(1, 3, figsize=(8.6, 3.1))
    for axis, picture, title in (
        (axes[0], truth, "Poulin and Fournier's cylinders"),
        (axes[1], found, "p(ωo) q(h) p(ωi)"),
    ):
        axis.imshow(shown(picture, white))
        axis.set_title(title, fontsize=9)
        bare(axis)
    grey, other = truth @ LUMINANCE, found @ LUMINANCE
    error = np.where(grey > 0.0, other / np.where(grey > 0.0, grey, 1.0) - 1.0, np.nan)
    drawn = axes[2].imshow(error, cmap="RdBu_r", vmin=-0.5, vmax=0.5)
    axes[2].set_title(f"relative error, median {np.nanmedian(np.abs(error)):.2f}", fontsize=9)
    bare(axes[2])
    figure.colorbar(drawn, ax=axes[2], fraction=0.046)
    save(figure, "factorization_figure_5.png")


def measured(shared: Path) -> None:
    """Luminance over the half vector's angle at two differences: samples, the product alone, and with its peak."""
    files = [path for name in MEASURED if (path := shared / "data" / "brdf" / f"{name}.brdf").is_file()]
    if not files:
        return
    figure, axes = plt.subplots(1, len(files), figsize=(5.2 * len(files), 3.8), squeeze=False)
    for axis, path in zip(axes[0], files, strict=True):
        item = load_material(path)
        samples = sample_reflectance(item.reflectance)
        alone, apart = (
            factor_reflectance(item.name, item.reflectance, options).value
            for options in (FactoringOptions(peak="off"), None)
        )
        h = warps.half_vector(samples.wi, samples.wo)
        theta_h = np.degrees(np.arccos(np.clip(h[:, 2], -1.0, 1.0)))
        theta_d = np.degrees(np.arccos(np.clip(np.sum(samples.wi * h, axis=1), -1.0, 1.0)))
        for (low, high), colour in zip(
            ((5.0, 25.0), (40.0, 55.0), (65.0, 80.0)), ("C0", "C1", "C2"), strict=True
        ):
            seen = (theta_d >= low) & (theta_d < high)
            axis.scatter(
                np.maximum(theta_h[seen], 0.05),
                samples.values[seen] @ LUMINANCE,
                s=5,
                color=colour,
                alpha=0.5,
            )
            tilt = np.geomspace(0.05, 85.0 - 0.5 * (low + high), 200)
            wi, wo = pair(np.radians(tilt), np.radians(0.5 * (low + high)))
            for value, dash in ((apart, "-"), (alone, ":")):
                axis.plot(tilt, value.eval(wi, wo) @ LUMINANCE, dash, color=colour, linewidth=1.2)
            axis.plot([], [], color=colour, label=f"θd {low:g}…{high:g}°")
        axis.plot([], [], "k-", label="peak apart")
        axis.plot([], [], "k:", label="one product")
        axis.set(
            xscale="log",
            yscale="log",
            xlabel="θh (°)",
            ylabel="luminance of f_r (1/sr)",
            title=path.stem.replace("_", " "),
        )
        axis.set_ylim(1e-3, None)
        axis.legend(fontsize=7)
    save(figure, "factorization_measured.png")


def pair(theta_h: Floats, theta_d: float) -> tuple[Floats, Floats]:
    """Return light and view on both sides of half vectors, across the plane of their tilt."""
    h = spherical(theta_h, np.zeros_like(theta_h))
    across = np.array([0.0, 1.0, 0.0])
    return tuple(h * np.cos(theta_d) + sign * np.sin(theta_d) * across for sign in (1.0, -1.0))


def save(figure, name: str) -> None:
    """Write a figure and close it."""
    figure.tight_layout()
    figure.savefig(IMAGES / name, dpi=100)
    plt.close(figure)
    print(f"{IMAGES / name}: {(IMAGES / name).stat().st_size // 1000} kB")


if __name__ == "__main__":
    main()
