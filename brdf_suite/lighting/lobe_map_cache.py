"""Prefiltered maps, from disk where they were filtered before (:mod:`brdf_suite.files.cache.disk_cache`).

The key is a hash of the environment's pixels, the exponents, the versions of algorithm and file, and the largest face
size. The maps of the default light come with the programs (``packaging/generators/resources.py lobe_maps`` writes
them): they are looked for first, under the same key, and are never copied into the user's folder.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence

from brdf_suite.errors import PathLike
from brdf_suite.files.cache.disk_cache import DiskCache
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.prefilter import (
    ALGORITHM_VERSION,
    LobeMaps,
    Ready,
    background_size,
    prefilter,
)
from brdf_suite.lighting.lobe_map_file import PLAIN, encode_maps, read_maps, read_packed_maps
from brdf_suite.progress import Progress, report
from brdf_suite.resources import resource_root

PACKAGED = "lobe_maps"
"""The folder, among the resources, of the maps that come with the programs."""
PACKAGED_ENDING = ".packedmaps"


class MapCache(DiskCache):
    """The filtered maps on disk; arguments as for :class:`DiskCache`.

    >>> maps = MapCache().get_or_compute(environment, [3.0, 40.0])  # doctest: +SKIP
    """

    def __init__(
        self,
        root: PathLike | None = None,
        *,
        limit_bytes: int | None = None,
        lock_timeout_s: float = 600.0,
        silence_s: float = 60.0,
    ) -> None:
        super().__init__(
            "lobe_maps",
            "maps",
            PLAIN,
            ".lobemaps",
            root,
            limit_bytes=limit_bytes,
            lock_timeout_s=lock_timeout_s,
            silence_s=silence_s,
        )

    def get_or_compute(
        self,
        environment: Environment,
        exponents: Sequence[float],
        progress: Progress | None = None,
        ready: Ready | None = None,
    ) -> LobeMaps:
        """Return the maps of :func:`prefilter`, from disk where they are there; ``ready`` as there.

        Only an unsound request or a cancelled ``progress`` raises.
        """
        key = cache_key(environment, exponents)
        shipped = resource_root() / PACKAGED / f"{key}{PACKAGED_ENDING}"
        found = self.packaged(shipped, lambda path: read_packed_maps(path, key)) or self.get_or_make(
            key,
            lambda path: read_maps(path, key),
            lambda watched: prefilter(environment, exponents, watched, ready),
            lambda maps: encode_maps(maps, key, environment.name),
            progress,
        )
        report(progress, 1.0, "the environment is filtered")
        return found


def cache_key(environment: Environment, exponents: Sequence[float]) -> str:
    """Return the name of the maps of an environment and exponents: 64 hexadecimal digits."""
    parts = [
        environment.content_hash,
        [float(exponent) for exponent in exponents],
        ALGORITHM_VERSION,
        PLAIN.version,
        background_size(environment),
    ]
    return hashlib.sha256(json.dumps(parts).encode()).hexdigest()
