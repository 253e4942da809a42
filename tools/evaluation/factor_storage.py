"""Quantization of a factorization's maps as 8-bit, half or full float textures, and its error.

A texture holds either a factor itself, divided by its largest value (section 4.1, the normalized p' and q'; α takes the
rest), or its logarithm, stretched over the texture's range: the latter keeps a relative error.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.fitting.homomorphic.factorization import Factorization

Store = Literal["8-bit", "half", "float"]
STORES: Mapping[str, int] = MappingProxyType({"8-bit": 1, "half": 2, "float": 4})
"""Kind of texture: bytes of a number."""


@dataclass(frozen=True)
class QuantizedFactorization:
    """A factorization after quantization to textures, and the bytes of all its maps."""

    product: Factorization
    texture_bytes: int


def quantize_maps(
    product: Factorization, store: Store, *, logarithmic: bool = False
) -> QuantizedFactorization:
    """Return ``product`` after its maps went through textures of ``store``."""
    logs: dict[str, Floats] = {}
    alpha = product.alpha.copy()
    for name, given in product.logs.items():
        # What no pair reads takes no part in the range.
        read = given[_read(product, name)]
        low, top = read.min(axis=0), read.max(axis=0)
        values = np.clip(given, low, top)
        if logarithmic:
            span = np.maximum(top - low, 1e-12)
            logs[name] = low + span * _through((values - low) / span, store)
        else:
            kept = np.maximum(_through(np.exp(values - top), store), 1e-30)
            logs[name] = np.log(kept)
            alpha *= np.exp(top * sum(factor.name == name for factor in product.factors))
    count = sum(values.size for values in product.logs.values())
    return QuantizedFactorization(Factorization(product.factors, logs, alpha), count * STORES[store])


def _read(product: Factorization, name: str) -> npt.NDArray[np.bool_]:
    """Return which texels of a map are read at all: of a hemisphere's, those that its disc touches, and their next."""
    shape = product.logs[name].shape[:-1]
    if not next(factor.projection.hemisphere for factor in product.factors if factor.name == name):
        return np.ones(shape, np.bool_)
    along = np.maximum(np.abs((2.0 * np.arange(shape[0]) + 1.0) / shape[0] - 1.0) - 2.0 / shape[0], 0.0)
    return np.asarray(np.hypot(along[:, None], along) < 1.0)


def compression(product: Factorization, samples: int) -> float:
    """Return the samples of a table over the texels of the maps (the ratio of Table 1)."""
    return samples / sum(values[..., 0].size for values in product.logs.values())


def _through(values: Floats, store: Store) -> Floats:
    """Return numbers of [0, 1] as a texture gives them back."""
    if store == "8-bit":
        return np.asarray(np.rint(255.0 * values) / 255.0)
    return values.astype(np.float16 if store == "half" else np.float32).astype(np.float64)
