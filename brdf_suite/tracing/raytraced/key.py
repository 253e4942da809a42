"""The key of a ray-traced scene: a hash of all that its light depends on, and nothing of how it is shown."""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict

import numpy as np

from brdf_suite.documents.store import view_to_json
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.surface.mesh import Mesh
from brdf_suite.tracing.raytraced.scene_parts import PAINT, PictureInputs

_LIT_BY = ("camera", "rotation_deg", "fresnel", "light_colour", "lamps", "sparkle", "surface_look")
_VERSION = 1


def scene_key(inputs: PictureInputs, mesh: Mesh) -> str:
    """Return a word that is the same for the same light, whatever its exposure, tone curve or backdrop."""
    document = view_to_json(inputs.view)
    shown = {name: document[name] for name in _LIT_BY if name in document}
    quality = {**asdict(inputs.quality), "tables": inputs.tables, "version": _VERSION}
    digest = hashlib.sha256(json.dumps([shown, quality], sort_keys=True).encode())
    paint = inputs.paint
    digest.update(repr((paint.name, paint.flakes, inputs.size, inputs.environment.content_hash)).encode())
    if isinstance(paint.reflectance, LobeWeights):
        for array in (paint.reflectance.kd, paint.reflectance.kdd, paint.reflectance.kg):
            digest.update(np.asarray(array).tobytes())
    else:
        # The reflectance by what it is: values at some directions differ wherever two pictures could.
        rng = np.random.default_rng(1)
        directions = rng.normal(size=(2, 256, 3))
        directions /= np.linalg.norm(directions, axis=-1, keepdims=True)
        directions[..., 2] = np.abs(directions[..., 2])
        digest.update(np.round(paint.reflectance.eval(directions[0], directions[1]), 9).tobytes())
    for p in mesh.parts:
        if p.material != PAINT:
            digest.update(p.material.encode())
        digest.update(p.positions.tobytes())
        digest.update(p.triangles.tobytes())
    return digest.hexdigest()
