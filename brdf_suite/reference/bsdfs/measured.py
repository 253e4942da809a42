"""A material of an RGL ``.bsdf`` file in the renderer: Mitsuba's own plug-in ``measured`` does the look-up.

The file's incident direction is the light's to us and the view's to Mitsuba, and measured values are not quite the same
the other way round. So the plug-in is asked with the two exchanged. Spectra become colours before: both are linear.
"""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from brdf_suite.files.measured.rgl import write_rgl
from brdf_suite.reference.bsdfs.directions import Colour, Vector
from brdf_suite.reference.bsdfs.fitted_samplers import fitted_samplers
from brdf_suite.reference.bsdfs.terms import Sampler
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reflectance.tensor.tensor_reflectance import TensorReflectance


@dataclass(frozen=True, eq=False)
class MeasuredTerm:
    """Term of a :class:`~brdf_suite.reflectance.tensor.tensor_reflectance.TensorReflectance`."""

    plug_in: Any
    samplers: Sequence[Sampler]

    @classmethod
    def of(cls, material: TensorReflectance) -> MeasuredTerm:
        """Return the counterpart of a material."""
        # Outside of the working space a channel is negative, and what that leaves of a sum is cut off at the end.
        colours = np.einsum("picab,cj->pijab", material.values, material.to_working)
        table = replace(material, values=np.ascontiguousarray(colours, np.float32), wavelengths_nm=None)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "material.bsdf"
            write_rgl(table, path)
            plug_in = mi.load_dict({"type": "measured", "filename": str(path)})
        return cls(plug_in, fitted_samplers(material))

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        si: Any = dr.zeros(mi.SurfaceInteraction3f)
        si.wi = light
        return dr.maximum(self.plug_in.eval(mi.BSDFContext(), si, view) / view.z, 0.0)
