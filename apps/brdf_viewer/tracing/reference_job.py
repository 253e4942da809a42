"""The path tracer as a :class:`~brdf_viewer.tracing.job.Job`; it needs Mitsuba, which is optional."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.view import View
from brdf_suite.errors import SuiteError
from brdf_suite.reference.estimate_file import write_estimate
from brdf_suite.reference.passes import check_denoiser, denoise_picture
from brdf_suite.tracing.reference.live import LiveReference
from brdf_viewer.tracing.job import TracedFrame, add_coverage


class ReferenceJob:
    """The path tracer: unbiased, without end."""

    def __init__(self, live: LiveReference, *, grounded: bool = False) -> None:
        self._live = live
        self.title = live.scene.renderer
        self.notices = live.scene.notices
        if grounded:
            self.notices = (*self.notices, "The ground shadow is that of the real-time picture.")
        self.no_denoiser = ""
        try:
            check_denoiser()
        except SuiteError:
            self.no_denoiser = "The denoiser (OptiX) needs an NVIDIA graphics card, which is not used here."

    def frames(self) -> Iterator[TracedFrame]:
        """Yield ever better pictures without end; first what there is of this very light already."""
        known = self._live.estimate
        while True:
            estimate, known = known or self._live.step(), None
            yield TracedFrame(
                add_coverage(estimate.radiance, estimate.coverage),
                estimate.samples,
                0,
                estimate.noise if np.isfinite(estimate.noise) else None,
                estimate.seconds,
            )

    def denoise_picture(self, pixels: NDArray[np.float32]) -> NDArray[np.float32]:
        """Take the noise out of the light; the object's edge stays as it is."""
        return add_coverage(denoise_picture(pixels[..., :3].astype(np.float64)), pixels[..., 3])

    def save(self, path: Path, view: View) -> None:
        """Write radiance, variance and all that a render goes on from."""
        estimate = self._live.estimate
        if estimate is None:
            raise SuiteError("There is no picture yet.")
        scene = replace(self._live.scene, view=replace(view, camera=self._live.scene.view.camera))
        comments = (
            f"{scene.name} on {scene.surface} in {scene.environment}, path-traced, {estimate.samples} samples"
        )
        write_estimate(path, estimate, scene.whole(estimate), scene.key, {"comments": comments})
