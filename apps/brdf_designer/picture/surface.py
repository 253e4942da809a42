"""The widget of the picture, the same as Viewer's. Imported only where there is OpenGL, which it needs."""

from __future__ import annotations

from collections.abc import Callable

from brdf_qt.gl.surface import GlSurface

from brdf_designer.picture.contents import PictureContents
from brdf_designer.picture.drawer import Grey, PictureDrawer
from brdf_suite.realtime.gl.context import Context


def make_surface(
    contents: PictureContents,
    surround: Callable[[], Grey],
    made: Callable[[PictureDrawer], None],
    better: Callable[[], None],
) -> GlSurface:
    """Return the widget that draws ``contents``; ``made`` is called with the drawer of each new context.

    ``surround`` and ``better`` as for :class:`PictureDrawer`.
    """

    def make(context: Context) -> PictureDrawer:
        drawer = PictureDrawer(context, contents, surround, better)
        made(drawer)
        return drawer

    # The renderer averages its samples by itself, in linear light.
    return GlSurface(make, samples=0)
