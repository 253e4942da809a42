"""Readings of a report under another illuminant: recomputed from spectra where known, else adapted."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.spectra import DEFAULT_WAVELENGTHS_NM, spectrum_to_working
from brdf_suite.appearance.geometries import Geometry
from brdf_suite.appearance.light.colour import (
    ColourUnderLight,
    adapt_colour,
    colour_from_spectra,
    metamerism_index,
)
from brdf_suite.arrays import Floats
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.reflectance.instruments.aperture import Aperture, reflectance_factor
from brdf_suite.reflectance.instruments.spectrophotometer import InstrumentReport
from brdf_suite.reflectance.protocol import Reflectance, SpectralReflectance, has_spectra
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples


@dataclass(frozen=True, eq=False)
class Relit:
    """The colours of ``source`` under ``illuminant``, one of the suite's, with chromatic adaptation; 10° observer.

    Its values are those of the colour that has, under D65, the L*a*b* that the spectrum has under the illuminant: what
    metamerism does to it is in them. Seen without adaptation, the picture is turned to the illuminant's white later.
    """

    source: SpectralReflectance
    illuminant: str

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3), working space, 1/sr, without the cosine, never negative; 0 below the horizon."""
        return _colours(self.source.eval_spectra(wi, wo), self.source, self.illuminant)


def relit(reflectance: SpectralReflectance, illuminant: str) -> Reflectance:
    """Return a reflectance with spectra under an illuminant; samples stay samples, with other values."""
    if isinstance(reflectance, ScatteredSamples) and reflectance.spectra is not None:
        return replace(reflectance, values=_colours(reflectance.spectra, reflectance, illuminant))
    return Relit(reflectance, illuminant)


def _colours(spectra: Floats, source: SpectralReflectance, illuminant: str) -> Floats:
    bands = np.asarray(source.wavelengths_nm, np.float64)
    return np.maximum(spectrum_to_working(spectra, bands, illuminant=illuminant), 0.0)


@dataclass(frozen=True)
class _Bands:
    """The bands of a spectral reflectance as an ``eval``, for the aperture's integral."""

    source: SpectralReflectance

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        return self.source.eval_spectra(wi, wo)


def spectrum_at(reflectance: SpectralReflectance, geometry: Geometry, aperture: Aperture) -> Floats:
    """Return the reflectance factor (k,) per band at a geometry, through an aperture."""
    wi = illumination(geometry.illumination_deg)
    wo = aspecular_view(geometry.illumination_deg, geometry.aspecular_deg)
    return reflectance_factor(_Bands(reflectance), wi, wo, aperture)[0]


def readings_under(
    reflectance: Reflectance, report: InstrumentReport, illuminant: str, observer_deg: int = 10
) -> tuple[ColourUnderLight, ...]:
    """Return the colour of each of the report's readings under D65, A or F11.

    Each says in its ``label`` how it was found. Adapted colours are of the 10° observer, as the readings are.
    """
    if not has_spectra(reflectance):
        return tuple(adapt_colour(reading.lab, illuminant) for reading in report.readings)
    return tuple(
        colour_from_spectra(
            spectrum_at(reflectance, reading.geometry, report.aperture),
            np.asarray(reflectance.wavelengths_nm, float),
            illuminant,
            observer_deg,
        )
        for reading in report.readings
    )


def metamerism(
    reference: SpectralReflectance,
    sample: SpectralReflectance,
    geometry: Geometry,
    aperture: Aperture,
    illuminant: str,
) -> float:
    """Return the metamerism index (ΔE*ab, D65 to ``illuminant``, 10°) of two spectral reflectances at a geometry."""
    bands = DEFAULT_WAVELENGTHS_NM
    # The spectra at the suite's own bands, straight between the reflectances'.
    first, second = (
        np.interp(bands, np.asarray(item.wavelengths_nm, float), spectrum_at(item, geometry, aperture))
        for item in (reference, sample)
    )
    return float(metamerism_index(first, second, bands, illuminant))
