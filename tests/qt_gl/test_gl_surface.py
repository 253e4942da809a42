"""The OpenGL widget: real context, real pixels, and messages in place of a black picture."""

from __future__ import annotations

import os
import subprocess
import sys
import textwrap

import moderngl
import pytest
from brdf_qt.gl.surface import SLOW_MS, GlSurface
from brdf_qt.program.application import surface_format
from PySide6.QtCore import QEvent, QObject
from PySide6.QtGui import QColor, QSurfaceFormat
from PySide6.QtWidgets import QLabel, QMainWindow, QPushButton, QWidget

from brdf_suite.errors import GraphicsError

VERTEX = """#version 330 core
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0, 0.0, 1.0); }"""
FRAGMENT = """#version 330 core
uniform vec3 colour; out vec4 pixel; void main() { pixel = vec4(colour, 1.0); }"""


class Triangle:
    """Clears to black and fills one half with the view, an RGB triple."""

    def __init__(self, context: moderngl.Context) -> None:
        self.context = context
        self.program = context.program(vertex_shader=VERTEX, fragment_shader=FRAGMENT)
        self.array = context.vertex_array(self.program, [])
        self.sizes: list[tuple[int, int]] = []
        self.error: Exception | None = None
        self.released = False
        self.drawn = lambda: None

    def draw(self, framebuffer, size, view) -> bool:
        if self.error is not None:
            raise self.error
        framebuffer.use()
        framebuffer.clear()
        self.program["colour"] = view
        self.array.render(moderngl.TRIANGLES, vertices=3)
        self.sizes.append(size)
        self.drawn()
        return True

    def release(self) -> None:
        self.array.release()
        self.program.release()
        self.released = True


@pytest.fixture
def drawers() -> list[Triangle]:
    return []


@pytest.fixture
def surface(qtbot, drawers):
    def make(context: moderngl.Context) -> Triangle:
        drawers.append(Triangle(context))
        return drawers[-1]

    surface = GlSurface(make)
    window = QMainWindow()
    window.setCentralWidget(surface)
    window.resize(320, 240)
    qtbot.addWidget(window, before_close_func=lambda _: surface.release())
    surface.set_view((1.0, 0.5, 0.0))
    with qtbot.waitSignal(surface.frame_drawn):
        window.show()
    surface.window_kept = window
    return surface


class PaintNote(QObject):
    """Notes when a widget is painted."""

    def __init__(self, widget: QWidget, order: list[str]) -> None:
        super().__init__(widget)
        self.order = order
        widget.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - the name is Qt's
        if event.type() == QEvent.Type.Paint:
            self.order.append("field")
        return super().eventFilter(watched, event)


@pytest.mark.parametrize("slow", [True, False])
def test_a_slow_picture_lets_the_fields_that_changed_with_it_go_first(surface, drawers, qtbot, slow) -> None:
    field = QLabel("old")
    bar = surface.window_kept.statusBar()
    bar.addWidget(field)
    qtbot.waitUntil(lambda: field.width() > 0 and field.isVisible())
    order: list[str] = []
    drawers[0].drawn = lambda: order.append("frame")
    qtbot.wait(50)  # what showing the field has asked for is painted
    PaintNote(field, order)
    surface.frame_ms = 2.0 * SLOW_MS if slow else 1.0
    surface.redraw()
    field.setText("new")
    qtbot.waitUntil(lambda: {"frame", "field"} <= set(order))
    if slow:
        assert order.index("field") < order.index("frame")


def test_it_shows_what_the_drawer_draws(surface, drawers, qtbot) -> None:
    image = surface.grab_image()
    assert (image.width(), image.height()) == (320, 240) == surface.device_size
    assert image.pixelColor(20, 220) == QColor(255, 128, 0)
    assert image.pixelColor(300, 20) == QColor(0, 0, 0)
    with qtbot.waitSignal(surface.frame_drawn) as drawn:
        surface.set_view((0.0, 0.0, 1.0))
    assert drawn.args[0] > 0
    assert drawn.args[1] is True
    assert surface.grab_image().pixelColor(20, 220) == QColor(0, 0, 255)


def test_edges_are_multisampled(surface) -> None:
    image = surface.grab_image()
    reds = {image.pixelColor(x, y).red() for x in range(320) for y in range(0, 240, 7)}
    assert len(reds - {0, 255}) >= 2  # 4 samples: quarters between the two


def test_a_new_size_reaches_the_drawer(surface, drawers, qtbot) -> None:
    surface.window_kept.resize(500, 300)
    qtbot.waitUntil(lambda: drawers[0].sizes[-1] == (500, 300))
    assert surface.grab_image().width() == 500


def test_an_error_while_drawing_gives_a_message_and_a_way_on(surface, drawers, qtbot) -> None:
    drawers[0].error = GraphicsError("shade.glsl, line 7: undefined name 'lobes'.")
    with qtbot.waitSignal(surface.failed) as failed:
        surface.redraw()
    assert "line 7" in failed.args[0]
    assert "line 7" in surface.failure
    assert surface.grab_image().isNull()
    assert not surface.canvas.isVisible()
    again = surface.findChild(QPushButton)
    assert again.isVisible()
    with qtbot.waitSignals([surface.canvas_changed, surface.frame_drawn]):
        again.click()
    assert drawers[0].released
    assert len(drawers) == 2
    assert surface.failure == ""
    assert surface.grab_image().pixelColor(20, 220) == QColor(255, 128, 0)


def test_an_opengl_error_is_not_a_black_picture(surface, drawers, qtbot, monkeypatch) -> None:
    def draw(framebuffer, size, view) -> bool:
        drawers[0].context.enable_direct(0xFFFF)  # an enumeration that OpenGL does not know
        return True

    drawers[0].draw = draw
    with qtbot.waitSignal(surface.failed) as failed:
        surface.redraw()
    assert "GL_INVALID_ENUM" in failed.args[0]


def test_a_failed_upload_is_reported(surface, drawers, qtbot) -> None:
    def upload() -> None:
        raise GraphicsError("the mesh needs more memory than the graphics card has.")

    with qtbot.waitSignal(surface.failed):
        surface.with_context(upload)
    assert "memory" in surface.failure


def test_a_factory_that_fails_is_reported(qtbot) -> None:
    def make(context: moderngl.Context) -> Triangle:
        context.program(vertex_shader="#version 330 core\nvoid main() { nonsense }", fragment_shader=FRAGMENT)

    surface = GlSurface(make)
    qtbot.addWidget(surface)
    surface.set_view((1.0, 1.0, 1.0))
    with qtbot.waitSignal(surface.failed) as failed:
        surface.show()
    assert "nonsense" in failed.args[0] or "syntax" in failed.args[0]


def test_another_window_is_another_context_and_the_picture_stays(surface, drawers, qtbot) -> None:
    """A widget that moves to another window loses its context: what was made in it is made anew."""
    other = QMainWindow()
    qtbot.addWidget(other)
    other.resize(300, 200)
    with qtbot.waitSignal(surface.frame_drawn):
        other.setCentralWidget(surface)
        other.show()
    qtbot.waitUntil(lambda: surface.failure or (len(drawers) == 2 and bool(drawers[1].sizes)))
    assert surface.failure == ""
    assert drawers[0].released
    assert surface.grab_image().pixelColor(20, 180) == QColor(255, 128, 0)
    with qtbot.waitSignal(surface.frame_drawn):
        surface.window_kept.setCentralWidget(surface)  # and back, to go with its own window
    assert len(drawers) == 3


def lose(surface, monkeypatch) -> None:
    """What Qt reports after a reset of the driver, which no test can make: the context is not valid any more."""
    canvas = surface.canvas
    monkeypatch.setattr(GlSurface, "is_lost", property(lambda _: surface.canvas is canvas))


def test_a_lost_context_is_replaced(surface, drawers, qtbot, monkeypatch) -> None:
    lose(surface, monkeypatch)
    with qtbot.waitSignals([surface.canvas_changed, surface.frame_drawn]):
        surface.redraw()
    assert surface.failure == ""
    assert len(drawers) == 2
    assert not drawers[0].released  # its objects went with the context
    assert surface.grab_image().pixelColor(20, 220) == QColor(255, 128, 0)


def test_a_context_that_is_lost_while_drawing_is_replaced(surface, drawers, qtbot, monkeypatch) -> None:
    drawers[0].error = moderngl.Error("the context is gone")
    canvas = surface.canvas
    asked = []
    lost = property(lambda _: surface.canvas is canvas and (asked.append(1) or len(asked) > 2))
    monkeypatch.setattr(GlSurface, "is_lost", lost)
    with qtbot.waitSignals([surface.canvas_changed, surface.frame_drawn]):
        surface.redraw()
    assert surface.failure == ""
    assert len(drawers) == 2


def test_a_context_that_is_lost_again_and_again_is_a_message(surface, drawers, qtbot, monkeypatch) -> None:
    for number in range(3):
        lose(surface, monkeypatch)
        with qtbot.waitSignal(surface.frame_drawn):
            surface.redraw()
        assert len(drawers) == number + 2
    lose(surface, monkeypatch)
    with qtbot.waitSignal(surface.failed) as failed:
        surface.redraw()
    assert "reset several times" in failed.args[0]
    with qtbot.waitSignal(surface.frame_drawn):
        surface.findChild(QPushButton).click()
    assert surface.failure == ""


def test_a_reset_of_the_driver_is_asked_to_be_reported() -> None:
    assert surface_format().testOption(QSurfaceFormat.FormatOption.ResetNotification)


def test_without_opengl_there_is_a_message(tmp_path) -> None:
    """In a process of its own, on the platform that has no OpenGL."""
    script = """
        from PySide6.QtWidgets import QApplication
        from brdf_qt.gl.surface import SLOW_MS, GlSurface
        app = QApplication([])
        surface = GlSurface(lambda context: None)
        surface.failed.connect(lambda text: (print(text), app.quit()))
        surface.show()
        app.exec()
    """
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    result = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(script)],
        env=environment,
        capture_output=True,
        text=True,
        timeout=240,
        check=True,
    )
    assert "OpenGL 3.3" in result.stdout
    assert "Traceback" not in result.stderr


def test_twice_the_pixels_at_twice_the_scale() -> None:
    script = """
        from PySide6.QtWidgets import QApplication
        from brdf_qt.gl.surface import SLOW_MS, GlSurface
        class Clear:
            def draw(self, framebuffer, size, view):
                framebuffer.use(); framebuffer.clear(1.0)
                print(size, framebuffer.viewport[2:], flush=True)
                return True
            def release(self): pass
        app = QApplication([])
        surface = GlSurface(lambda context: Clear())
        surface.resize(200, 150); surface.set_view(1)
        surface.frame_drawn.connect(lambda ms, typical: (print(surface.grab_image().size().toTuple()), app.quit()))
        surface.show(); app.exec(); surface.release()
    """
    environment = {**os.environ, "QT_SCALE_FACTOR": "2"}
    result = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(script)],
        env=environment,
        capture_output=True,
        text=True,
        timeout=240,
        check=True,
    )
    assert result.stdout.splitlines()[0] == "(400, 300) (400, 300)"
    assert "(400, 300)" in result.stdout.splitlines()[-1]


AFTER_A_PICTURE = """
from brdf_qt.program.application import surface_format
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import QApplication

from brdf_suite.pipeline.picture import OffscreenScene, gl_renderer_name

gl_renderer_name()
with OffscreenScene():
    pass
application = QApplication([])
widget = QOpenGLWidget()
widget.setFormat(surface_format(0))
widget.show()
while not widget.isVisible() or widget.context() is None:
    application.processEvents()
print("valid" if widget.isValid() else "no context")
"""


def test_a_window_has_a_context_after_pictures_without_one() -> None:
    """In a process of its own: what stays current of such a picture takes OpenGL from all later windows."""
    done = subprocess.run(
        [sys.executable, "-c", AFTER_A_PICTURE], capture_output=True, text=True, timeout=240, check=True
    )
    assert done.stdout.split() == ["valid"], done.stderr
