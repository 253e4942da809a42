"""Fits of a reflectance: cosine lobes, Cook-Torrance lobes, products of textures."""

from __future__ import annotations

from collections.abc import Sequence
from typing import cast, overload

import numpy as np
import numpy.typing as npt

from brdf_suite.errors import ValueRangeError
from brdf_suite.fitting.cook_torrance.reflectance_fit import FileFit
from brdf_suite.fitting.cook_torrance.reflectance_fit import fit_cook_torrance as fit_lobes
from brdf_suite.fitting.cook_torrance.settings import Loss, ModelName, Settings
from brdf_suite.fitting.homomorphic.reflectance_fit import (
    FactoredFit,
    FactoringOptions,
    MeanChoice,
    PeakChoice,
    factor_reflectance,
)
from brdf_suite.fitting.lobes.basis import LobeBasis, default_basis
from brdf_suite.fitting.lobes.program import Weighting
from brdf_suite.fitting.lobes.settings import Diffuse, FitSettings
from brdf_suite.library.subjects import Subject, material_for, title_of
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material
from brdf_suite.pipeline.material import SCATTERED, Material
from brdf_suite.progress import Progress
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples


def samples(
    wi: npt.ArrayLike, wo: npt.ArrayLike, values: npt.ArrayLike, *, name: str = "samples"
) -> Material:
    """Return measured values at scattered pairs of directions as a material, for every function that takes one.

    Between the samples the nearest ones are averaged by their distance.

    Parameters
    ----------
    wi, wo
        (n, 3) unit directions to the light and to the viewer, above the horizon, local frame with z along the normal.
    values
        (n, 3) f_r in 1/sr, linear Rec. 2020, without the cosine; or (n,), grey. Finite, not negative.
    name
        What the material is called.

    Raises
    ------
    ValueRangeError
        A shape does not fit, or a number is not as above; with its place.

    >>> import brdf_suite as bs
    >>> wi = bs.spherical([0.1, 0.5, 0.9], 0.0)
    >>> bs.samples(wi, bs.spherical([0.2, 0.6, 0.3], 3.0), [0.3, 0.2, 0.1]).eval(wi[0], wi[1]).shape
    (3,)
    """
    given = np.asarray(values, np.float64)
    if given.ndim == 1:
        given = np.repeat(given[:, None], 3, axis=1)
    light, view = np.asarray(wi, np.float64), np.asarray(wo, np.float64)
    return Material(name, ScatteredSamples(light, view, given), notices=(SCATTERED,))


def fit(
    subject: Subject,
    *,
    exponents: Sequence[float] | None = None,
    weighting: Weighting = "absolute",
    diffuse: Diffuse = "joint",
    errors: bool = False,
    progress: Progress | None = None,
) -> LobeFit:
    """Fit the cosine lobes that pictures are drawn with.

    Parameters
    ----------
    subject
        A name, a file, a paint, a material, :func:`samples`, or anything with ``eval``.
    exponents
        Of the lobes, 1 to 12 numbers above 0; left out, the suite's own eleven.
    weighting
        How much a sample counts, of paints with layers: ``absolute``, ``relative`` or ``solid angle``.
    diffuse
        Of paints with layers: fitted with the lobes (``joint``), or as ``measured`` off the mirror direction.
    errors
        Whether ``held_out``, the errors where the fit did not look, is worked out; it takes longer than the fit.
    progress
        Called with a share, 0 to 1, and a sentence; it may raise ``brdf_suite.errors.Cancelled``.

    Returns
    -------
    LobeFit
        Its ``weights`` are KD (3,), KDD and KG (lobes, 3) in 1/sr; ``eval(wi, wo)`` is f_r; ``worst_delta_e`` is the
        largest ΔE00 of its ``compared`` angles; ``notices`` are sentences about it.

    Raises
    ------
    SuiteError
        As :func:`load`; or nothing can be fitted to the values.

    >>> import brdf_suite as bs
    >>> fitted = bs.fit("blue")
    >>> fitted.weights.kdd.shape, fitted.worst_delta_e < 2.0
    ((11, 3), True)
    """
    basis = default_basis() if exponents is None else LobeBasis(tuple(float(one) for one in exponents))
    return fit_material(
        material_for(subject), FitSettings(basis, weighting, diffuse), errors=errors, progress=progress
    )


def fit_cook_torrance(
    subject: Subject,
    *,
    lobes: int = 3,
    model: ModelName = "cook-torrance",
    loss: Loss = "l1",
    starts: int = 8,
    samples: int = 6000,
    grazing_deg: float = 80.0,
    seed: int = 0,
    progress: Progress | None = None,
) -> FileFit:
    """Fit a matt part and Cook-Torrance lobes, as Günther et al. 2005 do for measured car paint.

    Parameters
    ----------
    subject
        As of :func:`fit`.
    lobes
        1 to 6.
    model
        ``cook-torrance``, ``ggx``, or ``ggx-clearcoat``, whose last lobe is a coat over the rest.
    loss
        ``l1``: mean of |ln(fit/measured)|; ``l2``: its square; ``robust``: deaf to outliers.
    starts
        1 to 64: from how many places the search sets out.
    samples
        100 to 200,000: the most that are looked at.
    grazing_deg
        10 to 90: light or view beyond this angle from the normal is left out.
    seed
        Of the choice of samples and starts.

    Returns
    -------
    FileFit
        ``fit`` has the lobes and their uncertainties; ``errors`` those over all values; ``paint`` is a paint of the
        lobes, of the model ``cook-torrance``; ``eval(wi, wo)`` is f_r.

    Raises
    ------
    SuiteError
        As :func:`load`; a setting is out of its range, or the values do not determine the lobes.

    >>> import brdf_suite as bs
    >>> found = bs.fit_cook_torrance("table1_white", lobes=1, starts=1, samples=300)
    >>> found.fit.model.lobes
    1
    """
    settings = Settings(lobes, model, loss, starts, seed, samples, grazing_deg)
    material = material_for(subject)
    return fit_lobes(title_of(material), material.reflectance, settings, progress=progress)


@overload
def factorize(
    subject: Subject,
    *,
    factors: str | None = None,
    resolution: int = 32,
    smoothness: float | None = None,
    bias: float | None = None,
    peak: PeakChoice = "auto",
    keep_mean: MeanChoice = "auto",
    radial: bool = False,
    pairs: int = 57_600,
    progress: Progress | None = None,
) -> FactoredFit: ...


@overload
def factorize(
    subject: npt.ArrayLike,
    wo: npt.ArrayLike,
    values: npt.ArrayLike,
    *,
    factors: str | None = None,
    resolution: int = 32,
    smoothness: float | None = None,
    bias: float | None = None,
    peak: PeakChoice = "auto",
    keep_mean: MeanChoice = "auto",
    radial: bool = False,
    pairs: int = 57_600,
    progress: Progress | None = None,
) -> FactoredFit: ...


def factorize(
    subject: Subject | npt.ArrayLike,
    wo: npt.ArrayLike | None = None,
    values: npt.ArrayLike | None = None,
    *,
    factors: str | None = None,
    resolution: int = 32,
    smoothness: float | None = None,
    bias: float | None = None,
    peak: PeakChoice = "auto",
    keep_mean: MeanChoice = "auto",
    radial: bool = False,
    pairs: int = 57_600,
    progress: Progress | None = None,
) -> FactoredFit:
    """Factor a reflectance, or samples of one, into a product of small textures (McCool, Ang and Ahmad 2001).

    Parameters
    ----------
    subject, wo, values
        Either a subject as of :func:`fit`; or three arrays, as of :func:`samples`: unit directions (n, 3) to the light
        and to the viewer, and f_r (n, 3) in 1/sr.
    factors
        Words ``map:projection``, as in ``"p:wo q:h p:wi"``; left out, as the reflectance suits.
    resolution
        Texels along a map, 2 to 512.
    smoothness
        Weight of the maps' Laplacian beside a sample's; left out, 4 of measured values, 1 of paints.
    bias
        What is added to each value, over their mean, as an error of measurement, above 0, at most 1; left out, 1e-2 of
        measured values, 1e-5 of paints.
    peak
        Whether the specular peak is kept apart: ``auto``, ``off``, ``radial`` or ``map``.
    keep_mean
        Whether the product reflects as much as the samples do: ``on``, ``off``, or where that brings it no farther.
    radial
        Whether maps that are radially symmetric are kept as their radius alone.
    pairs
        How many pairs of directions are drawn of a paint.

    Returns
    -------
    FactoredFit
        ``maps`` are textures (n, 3) or (n, n, 3) by their names; ``eval(wi, wo)`` is their product, f_r;
        ``accuracy`` has the errors; :func:`save` writes a ``.brdfpaint`` with its textures.

    Raises
    ------
    SuiteError
        As :func:`load` and :func:`samples`; a setting is out of its range, or every value is 0.

    >>> import brdf_suite as bs, numpy as np
    >>> wi = bs.spherical(np.linspace(0.05, 1.2, 400), 0.0)
    >>> wo = bs.spherical(np.tile(np.linspace(0.1, 1.1, 20), 20), np.linspace(0.0, 3.0, 400))
    >>> found = bs.factorize(wi, wo, bs.load("blue", bs.Material).eval(wi, wo), resolution=16)
    >>> found.samples, found.eval(wi, wo).shape
    (400, (400, 3))
    """
    if (wo is None) != (values is None):
        raise ValueRangeError("wo and values", "give one subject, or all of wi, wo and values")
    if wo is None or values is None:
        chosen = material_for(cast(Subject, subject))
    else:
        chosen = samples(cast(npt.ArrayLike, subject), wo, values)
    options = FactoringOptions(
        factors=factors,
        resolution=resolution,
        smooth=smoothness,
        bias=bias,
        peak=peak,
        keep_mean=keep_mean,
        radial=radial,
        pairs=pairs,
    )
    return factor_reflectance(title_of(chosen), chosen.reflectance, options, progress=progress)
