"""A running Viewer for each test: real window, real OpenGL on an X server, real files, settings of its own."""

from __future__ import annotations

import importlib
import importlib.util
import threading
import uuid
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from shiboken6 import isValid

from brdf_suite.files.meshes.reading import write_mesh_glb
from brdf_suite.lighting.procedural import sky, studio
from brdf_suite.pipeline import environments
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.surface import shape_mesh
from brdf_suite.realtime.environment import textures as environment_textures
from brdf_suite.realtime.gl import mesh_buffers
from brdf_suite.realtime.pictures.renderer import Renderer
from brdf_suite.surface.mesh import Mesh, PartGeometry


def _load(file: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(file.stem, file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


xvfb = _load(Path(__file__).parent.parent / "qt_gl" / "xvfb.py")
lasting = _load(Path(__file__).with_name("lasting.py"))


@pytest.fixture(scope="session", autouse=True)
def screen() -> None:
    """The display on which this session's widgets are shown."""
    xvfb.use_screen()


@pytest.fixture(autouse=True)
def own_cache(cache_folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One cache for the session: each environment is prefiltered once, and never into the user's cache."""
    monkeypatch.setenv("BRDF_SUITE_CACHE", str(cache_folder))


@pytest.fixture(autouse=True)
def own_session(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """No test touches a user's settings, or speaks with a program that is open."""
    monkeypatch.setenv("BRDF_SUITE_SETTINGS", str(tmp_path / "settings"))
    monkeypatch.setenv("BRDF_SUITE_LINK", f"test-{uuid.uuid4().hex[:12]}")


@pytest.fixture(autouse=True)
def exact_fits(monkeypatch: pytest.MonkeyPatch) -> None:
    """Fits are exact at once, however busy the machine is; the tests of the time limit set one of their own."""
    monkeypatch.setitem(PaintFitter.__init__.__kwdefaults__, "time_limit_s", 60.0)


@pytest.fixture
def drawn_swatches() -> None:
    """Thumbnails are drawn, by a process of their own, as for the user."""


@pytest.fixture(autouse=True)
def no_swatches(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Thumbnails keep their placeholders unless a test asks for ``drawn_swatches``: a process of each is slow."""
    if "drawn_swatches" not in request.fixturenames:
        monkeypatch.setattr("brdf_qt.work.pictures.child_command", lambda _module: [])


@pytest.fixture
def four_samples() -> None:
    """The picture is drawn with as many samples a pixel as the user's."""


@pytest.fixture(autouse=True)
def one_sample(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Draw one sample a pixel, in a quarter of the time, and coarse lights, unless a test asks for ``four_samples``.

    The programs that tests start draw with four, and so do pictures that fill the window.
    """
    if not {"four_samples", "filled"} & set(request.fixturenames):
        monkeypatch.setattr(Renderer.render, "__defaults__", (0,))
        coarse_lights(monkeypatch)


def coarse_lights(patch: pytest.MonkeyPatch) -> None:
    """Draw studios and skies with 128 rows, drafts with 64, and make no mip levels of the maps.

    A frame of 200 pixels shows no more of a light than that, and filtering the whole of it takes seconds.
    """
    patch.setattr(studio, "__defaults__", (128, *studio.__defaults__[1:]))
    patch.setattr(sky, "__defaults__", (128, *sky.__defaults__[1:]))
    patch.setattr(environments, "DRAFT_ROWS", 64)
    patch.setattr(environment_textures, "MIPMAPPED_FROM", 4096)


@pytest.fixture(scope="session")
def read_before() -> dict[tuple, object]:
    """What :func:`shared_scene` has read: the light, surface and occlusion that nearly all tests begin with."""
    return {}


@pytest.fixture(scope="session")
def coarse_sphere() -> Mesh:
    """The packaged sphere with a seventh of its triangles, which a small picture shows as round."""
    form = importlib.import_module("meshes.forms.sphere")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(form, "CELLS", 24)
        sphere: Mesh = form.sphere()
    return sphere


@pytest.fixture(autouse=True)
def shared_scene(
    request: pytest.FixtureRequest,
    read_before: dict,
    coarse_sphere: Mesh,
    lights: dict[str, Path],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Read the light and the surface that Viewers start with once a session, instead of twice a second.

    The sphere is a coarse one unless a test draws as the user's Viewer does: see :func:`one_sample`.
    """
    from brdf_qt.work import scene_loading as loading
    from brdf_viewer.surface import control

    first_light = str(lights["dim"])
    load, coarse = loading.load_shaped, not {"four_samples", "filled"} & set(request.fixturenames)
    if coarse:
        monkeypatch.setattr(
            loading,
            "load_shaped",
            lambda path, look, *more: (
                shape_mesh(coarse_sphere, look) if path == "sphere" else load(path, look, *more)
            ),
        )

    def share(module, name: str, key: Callable[..., object | None]) -> None:
        read = getattr(module, name)

        def read_once(*arguments, **options):
            place = name, key(*arguments)
            if place[1] is None:
                return read(*arguments, **options)
            if place not in read_before:
                read_before[place] = read(*arguments, **options)
            return read_before[place]

        monkeypatch.setattr(module, name, read_once)

    share(loading, "load_environment", lambda path, *_: path if path == first_light else None)
    share(loading, "load_shaped", lambda path, look, *_: (coarse, look) if path == "sphere" else None)
    spheres = {id(value) for place, value in read_before.items() if place[0] == "load_shaped"}
    share(control, "baked_occlusion", lambda mesh, *_: id(mesh) if id(mesh) in spheres else None)
    meshes = [value for place, value in read_before.items() if place[0] in ("load_shaped", "baked_occlusion")]
    known = {id(part.positions) for mesh in meshes for part in mesh.parts}
    share(mesh_buffers, "is_closed_outward", lambda points, *_: id(points) if id(points) in known else None)


def write_light(path: Path, up: float, front: float, back: float) -> Path:
    """Write a small environment: a bright sky, and another grey in front (+z) than behind."""
    from brdf_suite.files.images.environments import write_exr

    rows, columns = 32, 64
    pixels = np.empty((rows, columns, 3), np.float32)
    azimuth = np.abs(np.linspace(-1, 1, columns))  # 0 in the centre column, which looks along +z
    pixels[:] = np.where(azimuth < 0.5, front, back)[None, :, None]
    pixels[: rows // 4] = up
    write_exr(path, pixels)
    return path


@pytest.fixture(scope="session")
def lights(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Small environment files: ``dim`` and ``bright``."""
    folder = tmp_path_factory.mktemp("lights")
    return {
        "dim": write_light(folder / "dim.exr", 1.0, 0.3, 0.1),
        "bright": write_light(folder / "bright.exr", 6.0, 0.9, 0.2),
    }


PICTURE = (200, 160)


def is_idle(controller) -> bool:
    """Whether nothing is loaded or baked, and no strip of progress is shown or about to be."""
    parts = controller.scene, controller.surface, controller.studio
    busy = not all(part.is_idle for part in parts) or controller.window.busy
    return not busy and not controller.window.progress.isVisible()


class Viewer:
    """A shown Viewer and what a test does with it."""

    def __init__(self, controller, qtbot) -> None:
        self.controller = controller
        self.window = controller.window
        self.state = controller.state
        self.qtbot = qtbot

    @property
    def view(self):
        return self.state.view

    @property
    def canvas(self):
        return self.window.picture.canvas

    def pixels(self) -> np.ndarray:
        """Return the picture as it would be drawn now, (h, w, 3) uint8."""
        image = self.window.picture.grab_image()
        assert not image.isNull(), self.window.picture.failure
        flat = np.frombuffer(image.constBits(), np.uint8).reshape(
            image.height(), image.bytesPerLine() // 4, 4
        )
        return flat[:, : image.width(), 2::-1].copy()

    def close(self) -> None:
        close(self.controller)

    def wait_idle(self) -> None:
        self.qtbot.waitUntil(lambda: is_idle(self.controller))

    def messages(self) -> dict[str, str]:
        """Return what the window says, by key: all lines in one."""
        shown = self.window.messages.shown()
        return {key: " | ".join((m.what, m.where, m.todo)) for key, m in shown.items()}


def open_viewer(
    qtbot,
    lights: dict[str, Path],
    opened: list,
    *,
    paint: str = "blue",
    size: tuple[int, int] = (760, 480),
    fill: bool = False,
    wait: bool = True,
    **options,
) -> Viewer:
    """Open a Viewer as :func:`start` says; its controller is added to ``opened``."""
    from brdf_viewer.controller import ViewerController

    from brdf_suite.documents.view import View
    from brdf_suite.documents.view_settings import Sparkle

    QApplication.setQuitOnLastWindowClosed(
        False
    )  # the end of one program must not end the event loops of others
    view = options.pop("view", None) or View(
        environment=str(lights["dim"]), surface="sphere", sparkle=Sparkle(mode="off")
    )
    controller = ViewerController(view, paint, **options)
    opened.append(controller)
    if not fill:
        # Drawn in software a frame takes as long as it has pixels and flakes, and a test draws ten.
        controller.window.picture.setMaximumSize(*PICTURE)
    controller.window.resize(*size)
    if wait:
        complete = []
        controller.picture_complete.connect(lambda: complete.append(True))
        controller.window.show()
        qtbot.waitUntil(lambda: bool(complete or controller.window.picture.failure))
        assert not controller.window.picture.failure
        # What is baked in the background changes the picture, and its line in the window the picture's height.
        qtbot.waitUntil(lambda: is_idle(controller))
        controller.window.activateWindow()
    else:
        controller.window.show()
    return Viewer(controller, qtbot)


@pytest.fixture
def start(qtbot, lights) -> Iterator[Callable[..., Viewer]]:
    """Make Viewers; without arguments: a blue sphere in the ``dim`` light, in a small picture, without single flakes.

    With ``fill`` the picture fills the window, as it does for the user.
    """
    controllers: list = []
    yield lambda **options: open_viewer(qtbot, lights, controllers, **options)
    for controller in controllers:
        close(controller)


def close(controller) -> None:
    """Close the window as the user does, and take it away."""
    if isValid(controller):
        controller.window.close()
        controller.window.deleteLater()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def wait_until(callback: Callable[[], object]) -> None:
    """Wait as ``qtbot`` does, where no test runs."""
    while not callback():
        QTest.qWait(10)


@pytest.fixture(scope="session")
def kept_settings(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of the settings of a lasting Viewer while no test runs."""
    return tmp_path_factory.mktemp("settings")


@pytest.fixture(scope="session")
def lasting_viewers(kept_settings: Path) -> Iterator[Callable[..., Viewer]]:
    """Return a Viewer as ``start()`` makes it, that a test before may have used: see ``lasting.py``."""

    def close_apart(controller) -> None:
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv("BRDF_SUITE_SETTINGS", str(kept_settings))
            close(controller)

    yield from lasting.lasting_viewers(close_apart)


@pytest.fixture(scope="module")
def at_rest(lasting_viewers, kept_settings: Path, cache_folder: Path) -> Iterator[None]:
    """Bring the lasting Viewer back after the tests of a module: nothing of it runs on beside those of others."""
    yield
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("BRDF_SUITE_SETTINGS", str(kept_settings))
        patch.setenv("BRDF_SUITE_CACHE", str(cache_folder))
        patch.setattr(Renderer.render, "__defaults__", (0,))
        coarse_lights(patch)
        lasting_viewers(None, lambda controller: Viewer(controller, SimpleNamespace(waitUntil=wait_until)))


@pytest.fixture
def viewer(lasting_viewers, at_rest, qtbot, lights, monkeypatch: pytest.MonkeyPatch) -> Viewer:
    """A Viewer in the state in which ``start()`` makes it; a test that replaces a part of it starts its own."""
    opened: list = []
    viewer = lasting_viewers(
        lambda: open_viewer(qtbot, lights, opened), lambda controller: Viewer(controller, qtbot)
    )
    monkeypatch.setenv("BRDF_SUITE_LINK", viewer.link)  # where programs that the test starts meet it
    return viewer


@pytest.fixture
def filled(start) -> Viewer:
    """A Viewer whose picture fills its window."""
    return start(fill=True)


def _ball(name: str, x: float, material: str) -> PartGeometry:
    v, u = np.meshgrid(np.linspace(0.01, np.pi - 0.01, 17), np.linspace(0, 2 * np.pi, 33), indexing="ij")
    n = np.stack([np.sin(v) * np.sin(u), np.cos(v), np.sin(v) * np.cos(u)], -1).reshape(-1, 3)
    i = (np.arange(16)[:, None] * 33 + np.arange(32)).ravel()
    triangles = np.concatenate([np.stack([i, i + 33, i + 1], -1), np.stack([i + 1, i + 33, i + 34], -1)])
    return PartGeometry(name, material, n * 0.1 + [x, 0.1, 0.0], n, n[:, :2] * 100, triangles)


@pytest.fixture
def two_balls(tmp_path: Path) -> Path:
    """A mesh of two balls side by side: the left of paint, the right neutral."""
    path = tmp_path / "balls.glb"
    write_mesh_glb(Mesh("balls", (_ball("left", -0.12, "paint"), _ball("right", 0.12, "neutral"))), path)
    return path


class Slow:
    """Holds a reader up until ``go`` is set."""

    def __init__(self, read) -> None:
        self.go, self.begun, self._read = threading.Event(), threading.Event(), read

    def __call__(self, *given, **named):
        self.begun.set()
        assert threading.current_thread() is not threading.main_thread()
        assert self.go.wait(60.0)
        return self._read(*given, **named)


@pytest.fixture
def slow(monkeypatch):
    """Hold up the reader of that name in a module."""
    made = []

    def hold(module, name: str) -> Slow:
        made.append(Slow(getattr(module, name)))
        monkeypatch.setattr(module, name, made[-1])
        return made[-1]

    yield hold
    for one in made:
        one.go.set()
