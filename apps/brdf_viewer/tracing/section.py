"""Renderer of the picture, how good it is to become, and how far it is."""

from __future__ import annotations

from brdf_qt.fields.choices import ChoiceBox, note, set_note
from brdf_qt.fields.form import Form, fill_row
from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Section
from PySide6.QtWidgets import QCheckBox, QPushButton, QWidget

from brdf_viewer.tracing.process import TracedPicture

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


DEFAULT_SAMPLES = 1024


class RendererSection(Section):
    """Renderer of the picture, how good it is to become, and how far it is."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Renderer"), "renderer", parent)
        self.renderer = ChoiceBox(RENDERER_TITLES, RENDERER_TIPS)
        self.quality = ChoiceBox(QUALITY_TITLES)
        self.samples = NumberField(tr("Samples"), "", 0.0, 1_000_000.0, 64.0, 0, float(DEFAULT_SAMPLES))
        self.denoised = QCheckBox(tr("Denoise"))
        self.stop = QPushButton(tr("Stop"))
        self.stop.setToolTip(tr("Stop refining and free the processors"))
        self.resume = QPushButton(tr("Resume"))
        self.resume.setToolTip(tr("Refine the picture further"))
        self.save = QPushButton(tr("Save EXR…"))
        self.save.setToolTip(tr("Radiance of the current picture, with the variance of each pixel"))
        self._buttons = QWidget()
        fill_row(self._buttons, self.stop, self.resume, self.save, spacing=4, even=True)
        self.state, self.facts = note(lines=1), note()
        form = self.add(Form())
        form.add_row(tr("Picture"), self.renderer, tr("Renderer of the picture"))
        tip = tr("Lights, reflections and samples of the ray tracer: 16, 1, 1; 128, 16, 16; 1024, 256, 64")
        samples_tip = tr("Samples per pixel at which the path tracer stops; 0: unlimited")
        self._shown_for = {
            form.add_row(tr("Quality"), self.quality, tip): "raytraced",
            self.quality: "raytraced",
            form.add_row(tr("Samples"), self.samples, samples_tip): "reference",
            self.samples: "reference",
            form.add_row("", self.denoised): "reference",
            self.denoised: "reference",
        }
        form.add_wide(self._buttons, self.state, self.facts)
        self.set_denoiser(tr("The renderer has not been started yet."))
        self.show_renderer("realtime", "fast", DEFAULT_SAMPLES, denoised=False)
        self.show_work(running=False, stopped=False, has_picture=False)

    def show_renderer(self, renderer: str, quality: str, samples: int, *, denoised: bool) -> None:
        """Show the choice, without a signal; what says nothing of this renderer is hidden."""
        self.renderer.show_choice(renderer)
        self.quality.show_choice(quality)
        self.samples.set_value(float(samples))
        self.denoised.setChecked(denoised)
        for widget, key in self._shown_for.items():
            widget.setVisible(key == renderer)
        self._buttons.setVisible(renderer != "realtime")

    def set_denoiser(self, missing: str) -> None:
        """Offer to take the noise away; ``missing`` says why that cannot be, empty where it can."""
        self.denoised.setEnabled(not missing)
        tip = tr("A denoiser estimates detail hidden by noise: for viewing, not for measuring")
        self.denoised.setToolTip(plain_tip(missing or tip))

    def show_work(self, *, running: bool, stopped: bool, has_picture: bool) -> None:
        """Say what can be done now: stop what runs, go on with what was stopped, save what there is."""
        self.stop.setEnabled(running)
        self.resume.setEnabled(stopped)
        self.save.setEnabled(has_picture)

    def set_state(self, text: str, facts: str) -> None:
        """Say how far the picture is, and what this renderer does not show."""
        set_note(self.state, text)
        set_note(self.facts, facts)
