"""What is plotted: a material with its line, its fit, and what is known of its values."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.reflectance.material import Material
from brdf_suite.reflectance.protocol import Reflectance

if TYPE_CHECKING:
    from brdf_qt.documents.stamp import FileStamp

    from brdf_suite.pipeline.lobe_fit import LobeFit

Dash = Literal["solid", "dash", "dot", "dash dot", "long dash"]
DASHES: tuple[Dash, ...] = ("solid", "dash", "dot", "dash dot", "long dash")
Srgb = tuple[float, float, float]

LINE_COLOURS: tuple[Srgb, ...] = tuple(
    (int(code[0:2], 16) / 255.0, int(code[2:4], 16) / 255.0, int(code[4:6], 16) / 255.0)
    for code in ("56b4e9", "e69f00", "009e73", "cc79a7", "d55e00", "0072b2", "f0e442")
)
"""The lines' colours, in the order of use: Okabe and Ito's, distinguishable without full colour vision."""

Measured = Callable[[npt.ArrayLike, npt.ArrayLike], npt.NDArray[np.bool_]]
"""``(wi, wo) -> (...)``: whether a pair was measured, and not filled in from its neighbours; they broadcast."""


@dataclass(frozen=True, eq=False)
class SamplePoints:
    """Samples as they were measured: ``wi``, ``wo`` (n, 3) unit directions, ``values`` (n, 3) f_r in 1/sr."""

    wi: Floats
    wo: Floats
    values: Floats
    isotropic: bool = True


@dataclass(frozen=True, eq=False)
class PlottedMaterial:
    """A material with its line in plots and legend. Compare ``reflectance`` and ``fit`` by identity to see changes.

    - ``key``: its own, as long as the program runs; also when its material changes.
    - ``title``: its name in legend and plots, which the user may change.
    - ``colour``, ``dash``: its line: sRGB, 0 to 1, and a dash.
    - ``fit``: none until the fit is there, and where none can be had.
    - ``samples``: where the data are scattered samples.
    - ``measured``: where a table has holes: separates them from what was measured; None where there are none.
    - ``isotropic``: whether the azimuth of the incidence does not matter.
    - ``stamp``: of a model's text, what its file held as it was read.
    - ``notes``: what a user should know of it, each a sentence: the material's notices and what its values show.
    """

    key: str
    title: str
    material: Material
    colour: Srgb = LINE_COLOURS[0]
    dash: Dash = "solid"
    fit: LobeFit | None = None
    samples: SamplePoints | None = None
    measured: Measured | None = None
    isotropic: bool = True
    stamp: FileStamp | None = None
    notes: tuple[str, ...] = ()

    @property
    def reflectance(self) -> Reflectance:
        """f_r in 1/sr, linear Rec. 2020, without the cosine."""
        return self.material.reflectance
