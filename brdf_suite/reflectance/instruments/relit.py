"""Spectral reflectance under another illuminant, with chromatic adaptation.

Its values are those of the colour that has, under D65, the L*a*b* that the spectrum has under the illuminant: what
metamerism does to it is in them. Seen without adaptation, the picture is turned to the illuminant's white afterwards.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.spectra import spectrum_to_working
from brdf_suite.arrays import Floats
from brdf_suite.reflectance.protocol import Reflectance, SpectralReflectance
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples


@dataclass(frozen=True, eq=False)
class Relit:
    """The colours of ``source`` under ``illuminant``, one of those of the suite; 10° observer."""

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
