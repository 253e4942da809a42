"""What is said of a traced picture: over it, in the status bar and in its section."""

from __future__ import annotations

from brdf_qt.program.translation import mark, tr

from brdf_viewer.traced.process import TracedPicture

RENDERER_TITLES = {
    "realtime": mark("Real-time"),
    "raytraced": mark("Ray-traced"),
    "reference": mark("Path-traced"),
}
RENDERER_TIPS = {
    "realtime": mark("Fitted lobes in prefiltered light"),
    "raytraced": mark("The paint itself under many lights, with shadows and self-reflections"),
    "reference": mark("The paint itself, path-traced, as ground truth; refines while nothing changes"),
}
QUALITY_TITLES = {"fast": mark("Fast"), "medium": mark("Medium"), "high": mark("High")}
FROM_THE_WORKER = (
    mark("The ground shadow is that of the real-time picture."),
    mark("The denoiser (OptiX) needs an NVIDIA graphics card, which is not used here."),
    mark("The ray tracer uses the same lights in each pixel: there is no noise to remove."),
    mark("There is not enough memory for a picture of this size; make the window smaller."),
)
"""Texts of the tracing process, which loads no Qt; they are translated where they arrive."""


def picture_words(renderer: str, quality: str, picture: TracedPicture) -> str:
    """Return what a picture is: the preset, or its samples and the noise that is left."""
    words = [tr(RENDERER_TITLES[renderer])]
    if renderer == "raytraced":
        words = [tr("Ray-traced, {quality}").format(quality=tr(QUALITY_TITLES[quality]).lower())]
    if picture.of and not picture.done:
        words.append(tr("{count} of {all} samples").format(count=picture.samples, all=picture.of))
    elif renderer != "raytraced":
        words.append(tr("{count} samples").format(count=picture.samples))
    if picture.noise is not None:
        words.append(tr("noise {percent} %").format(percent=f"{100.0 * picture.noise:.2g}"))
    if picture.denoised:
        words.append(tr("denoised"))
    return "   ".join(words)


def rate_words(frame_s: float) -> str:
    """Return a frame rate, or the time of a frame where that says more.

    >>> rate_words(0.05), rate_words(4.0)
    ('20 frames/s', '4.0 s a frame')
    """
    if frame_s <= 0.0:
        return ""
    if frame_s > 1.0:
        return tr("{seconds} s a frame").format(seconds=f"{frame_s:.1f}")
    return tr("{rate} frames/s").format(rate=f"{1.0 / frame_s:.2g}")
