"""Renderer of the picture, how good it is to become, and how far it is."""

from __future__ import annotations

from brdf_qt.fields.choices import ChoiceBox, note, set_note
from brdf_qt.fields.form import Form, fill_row
from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Section
from PySide6.QtWidgets import QCheckBox, QPushButton, QStackedWidget, QWidget

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
    """Renderer of the picture, how good it is to become, and how far it is; ``rest`` is the section with its details.

    All has its place from the start, whatever the renderer: nothing moves with it.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Renderer"), "renderer", parent, titled=False)
        self.renderer = ChoiceBox(RENDERER_TITLES, RENDERER_TIPS)
        self.quality = ChoiceBox(QUALITY_TITLES)
        self.samples = NumberField(tr("Samples"), "", 0.0, 1_000_000.0, 64.0, 0, float(DEFAULT_SAMPLES))
        self.denoised = QCheckBox(tr("Denoise"))
        self.stop = QPushButton(tr("Stop"))
        self.stop.setToolTip(tr("Stop refining and free the processors"))
        self.resume = QPushButton(tr("Resume"))
        self.resume.setToolTip(tr("Refine the picture further"))
        buttons = QWidget()
        fill_row(buttons, self.stop, self.resume, spacing=8, even=True)
        self.state, self.facts = note(lines=1), note()
        form = self.add(Form())
        form.add_row(tr("Renderer"), self.renderer, tr("Renderer of the picture"))
        tip = tr("Lights, reflections and samples of the ray tracer: 16, 1, 1; 128, 16, 16; 1024, 256, 64")
        samples_tip = tr("Samples per pixel at which the path tracer stops; 0: unlimited")
        self._good, self._pages = (
            QStackedWidget(),
            {"realtime": QWidget(), "raytraced": Form(), "reference": Form()},
        )
        for page in self._pages.values():
            self._good.addWidget(page)
        self._add_page("raytraced", tr("Quality"), self.quality, tip)
        self._add_page("reference", tr("Samples"), self.samples, samples_tip)
        form.add_wide(self._good)
        form.add_row("", buttons)
        form.add_wide(self.state)
        self.rest = Section(tr("Traced picture"), "renderer_rest")
        rest = self.rest.add(Form())
        rest.add_row("", self.denoised)
        rest.add_wide(self.facts)
        self.set_denoiser(tr("The renderer has not been started yet."))
        self.show_renderer("realtime", "fast", DEFAULT_SAMPLES, denoised=False)
        self.show_work(running=False, stopped=False)

    def _add_page(self, renderer: str, text: str, field: QWidget, tip: str) -> None:
        form = self._pages[renderer]
        assert isinstance(form, Form)
        form.add_row(text, field, tip)

    def show_renderer(self, renderer: str, quality: str, samples: int, *, denoised: bool) -> None:
        """Show the choice, without a signal; what says nothing of this renderer is not offered."""
        self.renderer.show_choice(renderer)
        self.quality.show_choice(quality)
        self.samples.set_value(float(samples))
        self.denoised.setChecked(denoised)
        self._good.setCurrentWidget(self._pages[renderer])

    def set_denoiser(self, missing: str) -> None:
        """Offer to take the noise away; ``missing`` says why that cannot be, empty where it can."""
        self.denoised.setEnabled(not missing)
        tip = tr("A denoiser estimates detail hidden by noise: for viewing, not for measuring")
        self.denoised.setToolTip(plain_tip(missing or tip))

    def show_work(self, *, running: bool, stopped: bool) -> None:
        """Say what can be done now: stop what runs, go on with what was stopped."""
        self.stop.setEnabled(running)
        self.resume.setEnabled(stopped)

    def set_state(self, text: str, facts: str) -> None:
        """Say how far the picture is, and what this renderer does not show."""
        set_note(self.state, text)
        set_note(self.facts, facts)
