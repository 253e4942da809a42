"""A reflectance of any kind as a product of textures: f_r = α Π maps + peak, by homomorphic factorization."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Literal, get_args

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats, triple
from brdf_suite.documents.atomic import check_target
from brdf_suite.documents.factor_textures import write_textures
from brdf_suite.documents.factored import PARAMETERS, FactoredPaint
from brdf_suite.documents.store import PAINT_ENDING, save_paint
from brdf_suite.errors import FileError, PathLike, ValueRangeError
from brdf_suite.files.measured.brdftable import write_brdftable
from brdf_suite.fitting.homomorphic.factorization import (
    Accuracy,
    Factorization,
    accuracy,
    as_radial,
    asymmetries,
)
from brdf_suite.fitting.homomorphic.peak import (
    MEASURED_SMOOTHNESS,
    PEAK_BIAS,
    FactorizationWithPeak,
    factorize_with_peak,
)
from brdf_suite.fitting.homomorphic.product_fit import (
    BIAS,
    DEFAULT_RESOLUTION,
    FactorizationResult,
    correct_mean,
    factorize,
)
from brdf_suite.fitting.homomorphic.samples import (
    DEFAULT_PAIRS,
    DEFAULT_SEED,
    FactorizationSamples,
    sample_reflectance,
    samples_near_peak,
)
from brdf_suite.geometry.factor_words import (
    DEFAULT_FACTORS,
    MEASURED_FACTORS,
    Factor,
    factor_words,
    parse_factors,
)
from brdf_suite.notebook import Shown
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reflectance.factored.model import Factored, build_factored
from brdf_suite.reflectance.isotropy import is_isotropic
from brdf_suite.reflectance.protocol import Reflectance

PeakChoice = Literal["auto", "off", "radial", "map"]
PEAK_CHOICES: tuple[str, ...] = get_args(PeakChoice)
MeanChoice = Literal["auto", "on", "off"]
MEAN_CHOICES: tuple[str, ...] = get_args(MeanChoice)
TABLE_ENDING = ".brdftable"
MODEL_SMOOTHNESS = 1.0
"""λ of models: with a tenth of it maps follow the draw of the pairs, and miss others by more."""


@dataclass(frozen=True)
class FactoringOptions:
    """How a reflectance is factored; ``None`` lets the reflectance decide.

    ``factors``: words of :func:`~brdf_suite.geometry.factor_words.parse_factors`; left out, radial maps and one over
    Fresnel's angle where the reflectance is isotropic, p(ωo) q(h) p(ωi) where it is not. ``peak``: whether what stands
    out over the product is kept apart, over the radius of the half vector or as a map; ``auto``: radial where it is
    isotropic. ``bias`` is over the mean of what is factored; left out, 1e-2 of measurements, 1e-5 of models.
    ``smooth``: λ of equation 17; left out, 4 of measurements, 1 of models.
    ``keep_mean``: whether the mean of f_r cosθi cosθo over the samples is restored; ``auto``: where that raises neither
    the RMS error nor the median relative one. ``radial``: whether maps of two axes that are found to be radially
    symmetric are kept as their radius alone.
    """

    factors: str | None = None
    resolution: int = DEFAULT_RESOLUTION
    smooth: float | None = None
    bias: float | None = None
    peak: PeakChoice = "auto"
    keep_mean: MeanChoice = "auto"
    radial: bool = False
    pairs: int = DEFAULT_PAIRS
    seed: int = DEFAULT_SEED

    def __post_init__(self) -> None:
        for name, choices in (("peak", PEAK_CHOICES), ("keep_mean", MEAN_CHOICES)):
            if getattr(self, name) not in choices:
                reason = f"one of {', '.join(choices)} is wanted, not {getattr(self, name)!r}"
                raise ValueRangeError(name, reason)


@dataclass(frozen=True, eq=False)
class FactoredFit(Shown):
    """A product of textures beside what it came from.

    ``maps``: (n, 3) or (n, n, 3) by the names in ``factors`` and ``peak``, the words of how they are read; ``peak`` is
    empty where nothing stood out. ``asymmetry``: of each map
    over a hemisphere, by how much a texel misses the mean of its ring (RMS of the logarithm). ``mean_correction`` (3):
    what α was multiplied by. ``accuracy``: over the samples that were factored, of the textures as they are looked up.
    ``compression``: samples over texels. ``left_out``, ``raised``: samples that took no part, and negative ones that
    were taken for 0.
    """

    name: str
    value: Factored
    maps: Mapping[str, Floats]
    factors: str
    peak: str
    asymmetry: dict[str, float]
    mean_correction: tuple[float, float, float]
    accuracy: Accuracy
    compression: float
    samples: int
    left_out: int
    raised: int
    solver: str

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return what was fitted, f_r (..., 3) in 1/sr, linear Rec. 2020, without the cosine; 0 below the horizon.

        Parameters
        ----------
        wi, wo
            Unit directions (..., 3) to the light and to the viewer, z along the normal; they broadcast.

        >>> import brdf_suite as bs
        >>> found = bs.factorize("fine_silver", resolution=8, pairs=1000)
        >>> found.eval(bs.spherical([0.2, 0.4], 0.0), [0.0, 0.0, 1.0]).shape
        (2, 3)
        """
        return self.value.eval(wi, wo)

    def to_json(self) -> dict[str, object]:
        """Return the figures by their names, as JSON holds them; the maps' values are in :attr:`maps`.

        >>> import brdf_suite as bs
        >>> bs.factorize("fine_silver", resolution=8, pairs=1000).to_json()["samples"] > 500
        True
        """
        return {
            "name": self.name,
            "factors": self.factors,
            "peak": self.peak or None,
            "alpha": np.asarray(self.value.alpha, float).tolist(),
            "texels": {name: list(values.shape[:-1]) for name, values in self.maps.items()},
            "asymmetry": self.asymmetry,
            "mean_correction": list(self.mean_correction),
            "samples": self.samples,
            "left_out": self.left_out,
            "raised": self.raised,
            "solver": self.solver,
            "compression": self.compression,
            "accuracy": asdict(self.accuracy),
        }


def factor_reflectance(
    name: str,
    reflectance: Reflectance,
    options: FactoringOptions | None = None,
    *,
    progress: Progress | None = None,
) -> FactoredFit:
    """Factor a reflectance: a table, samples, a model, or a paint.

    Measured samples and the measured bins of tables are taken as they are; of models and paints directions even over
    both hemispheres are drawn, and where their peak is looked for, as many as a quarter of them about the mirror
    direction, where even ones hardly fall.

    Raises
    ------
    FittingError
        There is nothing to factor; the message says why.
    """
    chosen = options or FactoringOptions()
    report(progress, 0.0, "sampling")
    samples = sample_reflectance(reflectance, chosen.pairs, chosen.seed)
    bias, smooth = chosen.bias, chosen.smooth
    if bias is None:
        bias = BIAS if samples.even else PEAK_BIAS
    if smooth is None:
        smooth = MODEL_SMOOTHNESS if samples.even else MEASURED_SMOOTHNESS
    isotropic = is_isotropic(reflectance)
    words = MEASURED_FACTORS if isotropic else DEFAULT_FACTORS
    factors = parse_factors(words if chosen.factors is None else chosen.factors)
    fitting = subrange(progress, 0.1, 0.9)
    if chosen.peak == "off" or (chosen.peak == "auto" and not isotropic):
        found = factorize(
            samples.wi,
            samples.wo,
            samples.values,
            factors=factors,
            resolution=chosen.resolution,
            smooth=smooth,
            bias=bias,
            keep_mean=False,
            progress=fitting,
        )
        whole = FactorizationWithPeak(found.product, None)
    else:
        near = samples_near_peak(reflectance, chosen.pairs // 4, chosen.seed) if samples.even else None
        whole, found = factorize_with_peak(
            samples if near is None else samples.and_those(near),
            form="map" if chosen.peak == "map" else "radial",
            factors=factors,
            resolution=chosen.resolution,
            smooth=smooth,
            bias=bias,
            progress=fitting,
        )
    whole, correction = _mean(whole, samples, chosen.keep_mean)
    uneven = asymmetries(whole.product)
    if chosen.radial:
        whole = replace(whole, product=as_radial(whole.product))
    value, maps = _value(whole, samples, found, smooth, name)
    keep = np.isfinite(samples.values).all(axis=1)
    errors = accuracy(np.maximum(samples.values[keep], 0.0), value.eval(samples.wi[keep], samples.wo[keep]))
    peak = () if whole.peak is None else whole.peak.factors
    return FactoredFit(
        name,
        value,
        maps,
        factor_words(whole.product.factors),
        factor_words(peak),
        uneven,
        triple(correction),
        errors,
        found.used / sum(values[..., 0].size for values in maps.values()),
        found.used,
        found.left_out,
        found.raised,
        found.solver,
    )


def _mean(
    whole: FactorizationWithPeak, samples: FactorizationSamples, choice: MeanChoice
) -> tuple[FactorizationWithPeak, Floats]:
    """Correct α for the mean; return the correction too."""
    if choice == "off":
        return whole, np.ones(3)
    alone = samples.values if whole.peak is None else samples.values - whole.peak.eval(samples.wi, samples.wo)
    corrected, correction = correct_mean(whole.product, samples.wi, samples.wo, alone)
    better = replace(whole, product=corrected)
    distances = zip(_distances(whole, samples), _distances(better, samples), strict=True)
    if choice == "on" or all(after <= before for before, after in distances):
        return better, correction
    return whole, np.ones(3)


def _distances(one: FactorizationWithPeak, samples: FactorizationSamples) -> tuple[float, float]:
    """Return the RMS error, times √(cosθi cosθo), and the median relative error of the luminance.

    Where few samples hold most of the light, as in a peak, the first alone would brighten or darken all the rest.
    """
    keep = np.isfinite(samples.values).all(axis=1)
    wi, wo, values = samples.wi[keep], samples.wo[keep], samples.values[keep]
    error = one.eval(wi, wo) - values
    grey = values @ LUMINANCE
    lit = grey > 0.0
    relative = float(np.median(np.abs(error @ LUMINANCE)[lit] / grey[lit])) if lit.any() else 0.0
    return float(np.sqrt(np.mean(wi[:, 2:] * wo[:, 2:] * error**2))), relative


def _value(
    whole: FactorizationWithPeak,
    samples: FactorizationSamples,
    found: FactorizationResult,
    smooth: float,
    name: str,
) -> tuple[Factored, dict[str, Floats]]:
    """Return the textures: each map of the product over its largest value, and α with what that takes (equation 20)."""
    maps, alpha = _normalized(whole.product)
    peak: tuple[Factor, ...] = ()
    if whole.peak is not None:
        added, scale = _normalized(whole.peak)
        # The peak has no α of its own: its first map holds it.
        first = whole.peak.factors[0].name
        added[first] = added[first] * scale
        peak = whole.peak.factors
        clash = set(maps) & set(added)
        if clash:
            raise ValueRangeError("factors", f"the name {min(clash)!r} is the peak's; give the map another")
        maps |= added
    tiny = float(np.finfo(np.float32).tiny)
    maps = {key: np.maximum(values, tiny) for key, values in maps.items()}
    value = build_factored(
        whole.product.factors,
        {key: values.astype(np.float32) for key, values in maps.items()},
        alpha,
        peak=peak,
        source=f"homomorphic factorization of {name}",
        facts={
            "format": "product of textures",
            "factors": factor_words(whole.product.factors),
            "peak": factor_words(peak),
            "smoothness": smooth,
            "samples": found.used,
            "largest": float(np.nanmax(samples.values)),
        },
    )
    return value, maps


def _normalized(product: Factorization) -> tuple[dict[str, Floats], Floats]:
    maps: dict[str, Floats] = {}
    alpha = product.alpha.copy()
    counts = Counter(factor.name for factor in product.factors)
    for name, log in product.logs.items():
        top = log.reshape(-1, 3).max(axis=0)
        maps[name] = np.exp(log - top)
        alpha = alpha * np.exp(top * counts[name])
    # Beyond the range of α the first map that is read once keeps the rest: maps that no pair reads at their largest at
    # once may come to more than any reflectance.
    most = np.asarray(PARAMETERS["alpha"].high)
    once = [name for name, count in counts.items() if count == 1]
    if once:
        maps[once[0]] = maps[once[0]] * np.maximum(alpha / most, 1.0)
        alpha = np.minimum(alpha, most)
    return maps, alpha


def save_factored(found: FactoredFit, path: PathLike, *, name: str | None = None) -> None:
    """Write a factored fit as a ``.brdfpaint`` with its textures beside it, or as a ``.brdftable``.

    Raises
    ------
    FileError
        The ending is neither, or a file cannot be written.
    """
    target = Path(path)
    # Before the textures are written, which would be left behind.
    check_target(target)
    if target.suffix.lower() == TABLE_ENDING:
        write_brdftable(found.value, target)
        return
    if target.suffix.lower() != PAINT_ENDING:
        raise FileError(target, f"a product of textures goes into a {PAINT_ENDING} or a {TABLE_ENDING}")
    alpha = np.asarray(found.value.alpha, float)
    paint = FactoredPaint(
        name or found.name,
        write_textures({key: values.astype(np.float32) for key, values in found.maps.items()}, target),
        found.factors,
        triple(alpha),
        peak=found.peak,
        largest=float(found.value.facts["largest"]),
        source=found.value.source,
    )
    save_paint(paint, target)
