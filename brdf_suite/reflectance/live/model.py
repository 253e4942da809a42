"""A reflectance that a text defines, with values for its declared numbers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING
from brdf_suite.arrays import Floats
from brdf_suite.geometry.directions import illumination, mirror
from brdf_suite.reflectance.blocks import in_blocks
from brdf_suite.reflectance.half_vector_density import HalfVectorDensity, HalfVectorSampled
from brdf_suite.reflectance.isotropy import even_pairs, is_isotropic
from brdf_suite.reflectance.live.formulas import check_formulas, compute_formulas
from brdf_suite.reflectance.live.shader import compute_shader
from brdf_suite.reflectance.live.text import ModelText, read_model_text

_BLOCK = 4096
_TITLES = {"glsl": "Model text, GLSL", "python": "Model text, Python’s notation"}


@dataclass(frozen=True, eq=False)
class LiveModel(HalfVectorSampled):
    """The reflectance of a text.

    The text computes linear RGB with the primaries of sRGB, as the BRDF Explorer shows them; :meth:`eval` has them in
    the working space. What is negative, infinite or not a number is 0; :attr:`notes` say how much is no number.

    Parameters
    ----------
    model
        The text.
    values
        A value for each of its numbers, by key; those that are missing have their default.
    """

    model: ModelText
    values: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "values", {**self.model.defaults, **self.values})

    @staticmethod
    def of(text: str) -> LiveModel:
        """Return the model of a text with its defaults, once it has been computed for a few directions.

        Raises
        ------
        ModelTextError
            It is no model, or does not compile; with the line.
        GraphicsError
            It is GLSL, and there is no OpenGL, or it takes too long.
        """
        model = LiveModel(read_model_text(text))
        model.try_out()
        return model

    def try_out(self) -> None:
        """Compute some directions; errors as of :meth:`of`."""
        self.notes  # noqa: B018 - which computes them

    @cached_property
    def notes(self) -> tuple[str, ...]:
        """Sentences about directions without a finite value; errors as of :meth:`of`."""
        light = illumination([0.0, 45.0, 80.0])
        wi, wo = (np.concatenate(pair) for pair in zip(even_pairs(), (light, mirror(light)), strict=True))
        compute = compute_formulas if self.model.language == "python" else compute_shader
        share = float(np.mean(~np.isfinite(compute(self.model, wi, wo, self.values)).all(axis=-1)))
        if not share:
            return ()
        return (
            f"The text gives no finite value for {max(100.0 * share, 0.1):.1f} % of the directions; they are black.",
        )

    @property
    def facts(self) -> dict[str, object]:
        """Facts for tables and dialogs."""
        return {
            "format": _TITLES[self.model.language],
            "parameters": ", ".join(one.name for one in self.model.declared) or "none",
            "colour": "computed in linear sRGB",
            "notes": self.notes,
        }

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon.

        GLSL computes with single precision.

        Raises
        ------
        ModelTextError, GraphicsError
            As of :meth:`of`.
        """
        light, view = np.broadcast_arrays(np.asarray(wi, np.float64), np.asarray(wo, np.float64))
        if self.model.language == "python":
            check_formulas(self.model)  # here, for an error of the text is none of a block
            return in_blocks(self._compute, light, view, _BLOCK)
        return self._compute(light.reshape(-1, 3), view.reshape(-1, 3)).reshape(light.shape)

    def _compute(self, light: Floats, view: Floats) -> Floats:
        result = np.zeros((len(light), 3))
        above = (light[:, 2] > 0.0) & (view[:, 2] > 0.0)
        above &= np.isfinite(light.sum(axis=1) + view.sum(axis=1))
        if above.any():
            compute = compute_formulas if self.model.language == "python" else compute_shader
            found = compute(self.model, light[above], view[above], self.values)
            finite = np.where(np.isfinite(found).all(axis=-1, keepdims=True), found, 0.0)
            result[above] = np.maximum(finite, 0.0) @ REC709_TO_WORKING.T
        return result

    @cached_property
    def isotropic(self) -> bool:
        """Whether only the azimuth between light and view matters, as far as its values show."""
        return is_isotropic(self)

    @cached_property
    def _sampler(self) -> HalfVectorDensity:
        return HalfVectorDensity(self, isotropic=self.isotropic)
