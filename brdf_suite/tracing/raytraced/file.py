"""A paint by name or file, in a view, to a ray-traced picture file: within a budget, and to be gone on from."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter

from brdf_suite.documents.atomic import check_target
from brdf_suite.documents.view import View
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.images.environments import write_png
from brdf_suite.lighting.environment import Environment
from brdf_suite.pipeline.material import Material
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reference.raytraced.picture import read_sums, write_sums
from brdf_suite.reference.raytraced.quality import DEFAULT_PRESET, Quality, find_quality
from brdf_suite.reference.raytraced.table_split import TableSplit
from brdf_suite.regular_files import exists
from brdf_suite.tracing.raytraced.picture import RaytracedImage, RaytracedSession
from brdf_suite.tracing.traced_picture import Size, TracedFile, too_large

KEEP_EVERY_S = 20.0


@dataclass(frozen=True, kw_only=True)
class RaytracedPicture(TracedFile):
    """A ray-traced picture that was written; ``rounds`` of the quality's samples, the last of them whole or not."""

    lights: int
    reflections: int
    rounds: float


def render_raytraced(
    paint: PathLike | Material,
    view: View,
    size: Size,
    path: PathLike,
    *,
    quality: str | Quality = DEFAULT_PRESET,
    samples: int | None = None,
    seconds: float | None = None,
    fresh: bool = False,
    tables: TableSplit = "clamp",
    environment: Environment | None = None,
    progress: Progress | None = None,
) -> RaytracedPicture:
    """Ray-trace a picture and write it as PNG (as a screen shows it) or EXR (radiance, and the object apart).

    What is traced is kept in ``<path>.raytraced.part.exr`` every few seconds and when the progress callback cancels;
    the same call goes on from there, unless it is to begin ``fresh``.
    Errors as :meth:`.RaytracedSession.show` and :meth:`.RaytracedSession.passes`; Cancelled by the progress callback.

    Parameters
    ----------
    samples
        A pixel; those of the quality where they are not given. With more, lights are drawn anew round by round.
    seconds
        To trace at most; at least one pass is traced.
    environment
        One in memory, in place of the view's.
    """
    path = Path(path)
    if path.suffix.lower() not in (".png", ".exr"):
        raise FileError(path, "pictures are written as PNG or EXR; give a name that ends in .png or .exr")
    check_target(path)
    chosen = find_quality(quality)
    report(progress, 0.0, "starting the ray tracer")
    session = RaytracedSession()
    loading = subrange(progress, 0.0, 0.05)
    scene = session.show(paint, view, size, chosen, loading, tables=tables, environment=environment)
    kept = path.with_name(path.name + ".raytraced.part.exr")
    begun = None if fresh or not exists(kept) else read_sums(kept, scene.key)
    end = samples or chosen.samples
    if begun is not None and begun.samples > end:
        begun = None
    newest: RaytracedImage | None = RaytracedImage(scene, begun) if begun else None
    tracing = subrange(progress, 0.05, 0.98)
    clock = _Clock(end, begun.samples if begun else 0, seconds)
    report(tracing, 0.0, "tracing")
    last = perf_counter()
    try:
        for newest in session.passes(
            begun=begun, samples=end, between=lambda share: report(tracing, *clock.progress(share))
        ):
            clock.done(newest.sums.samples)
            if perf_counter() - last >= KEEP_EVERY_S:
                write_sums(kept, newest.sums, newest.whole(), scene.key)
                last = perf_counter()
            if clock.is_spent:
                break
    except BaseException:
        if newest is not None:  # cancelled, or out of memory: what is there is not lost
            write_sums(kept, newest.sums, newest.whole(), scene.key)
        raise
    assert newest is not None
    try:
        _write(path, newest)
    except MemoryError as error:
        raise too_large(size) from error
    kept.unlink(missing_ok=True)
    report(progress, 1.0, "written")
    return RaytracedPicture(
        **scene.file_facts(path),
        lights=chosen.lights,
        reflections=chosen.reflections,
        samples=newest.sums.samples,
        rounds=newest.sums.samples / chosen.samples,
        seconds=newest.sums.seconds,
        resumed_samples=begun.samples if begun else 0,
    )


class _Clock:
    """How much is done of a budget of samples and of time, and the words that report it."""

    def __init__(self, end: int, begun: int, seconds: float | None) -> None:
        self._end, self._begun, self._seconds = end, begun, seconds
        self._samples = self._before = begun
        self._start = perf_counter()

    def done(self, samples: int) -> None:
        """Take note of what a pass has brought."""
        self._before, self._samples = self._samples, samples

    @property
    def is_spent(self) -> bool:
        """Whether the time is up."""
        return self._seconds is not None and perf_counter() - self._start >= self._seconds

    def progress(self, within: float) -> tuple[float, str]:
        """Return the share that is done, ``within`` a pass of about the samples of the last one, and words."""
        step = max(self._samples - self._before, 1)
        ahead = min(self._samples + within * step, self._end) - self._begun
        share = ahead / max(self._end - self._begun, 1)
        spent = perf_counter() - self._start
        if self._seconds is not None:
            share = max(share, min(spent / self._seconds, 1.0))
        left = spent * (1.0 - share) / max(share, 1e-6)
        words = f"{self._samples} of {self._end} samples"
        return share, f"{words}, {duration_text(left)} left" if spent > 1.0 else words


def duration_text(seconds: float) -> str:
    """Return a duration in words.

    >>> duration_text(48.2), duration_text(600.0), duration_text(9000.0)
    ('48 s', '10 min', '2 h 30 min')
    """
    if seconds < 100.0:
        return f"{seconds:.0f} s"
    minutes = math.ceil(seconds / 60.0)
    return f"{minutes} min" if minutes < 100 else f"{minutes // 60} h {minutes % 60} min"


def _write(path: Path, image: RaytracedImage) -> None:
    scene, quality = image.scene, image.scene.quality
    metadata = {
        "Software": "BRDF Suite",
        "Title": scene.name,
        "Description": f"{scene.name} on {scene.surface} in {scene.environment}, ray-traced with {quality.lights} "
        f"lights, {quality.reflections} reflected rays and {image.sums.samples} samples a pixel, "
        f"{image.exposed_view.exposure_ev:+g} EV, tone curve {scene.view.tone_curve}",
    }
    if path.suffix.lower() == ".exr":
        write_sums(path, image.sums, image.whole(), scene.key, {"comments": metadata["Description"]})
    else:
        write_png(path, image.codes(), metadata)
