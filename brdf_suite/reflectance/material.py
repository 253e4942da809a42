"""A material: anything that reflects, with what is known of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from brdf_suite.documents.paint import Flakes, OrangePeel, Paint
from brdf_suite.documents.store import AnyPaint
from brdf_suite.reflectance.protocol import Reflectance


@dataclass(frozen=True, eq=False)
class Material:
    """Anything that reflects: a paint of any kind, measured data, a model.

    :func:`brdf_suite.pipeline.material.load_material` makes one from a name or a file.

    Parameters
    ----------
    name
        What the user calls it.
    reflectance
        f_r in 1/sr, linear Rec. 2020; of designed paints a
        :class:`~brdf_suite.reflectance.designed.paint_reflectance.PaintReflectance`.
    origin
        The name or path by which it was asked for, which distinguishes materials that share a ``name``; empty where
        it comes from neither.
    document
        The paint document that it was built from; None for measured data and models.
    notices
        Sentences for the user about how it was read and built.
    facts
        What a measured file says of itself, for tables and dialogs.
    observer_deg
        2 or 10: the observer through which measured spectra became colour.
    """

    name: str
    reflectance: Reflectance
    origin: str = ""
    document: AnyPaint | None = None
    flakes: Flakes | None = None
    orange_peel: OrangePeel | None = None
    notices: tuple[str, ...] = ()
    facts: Mapping[str, object] = field(default_factory=dict)
    observer_deg: int = 10

    @property
    def paint(self) -> Paint | None:
        """The document where it is a paint designed by its readings."""
        return self.document if isinstance(self.document, Paint) else None
