"""The widget of the picture, the same as Viewer's. Imported only where there is OpenGL, which it needs."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from brdf_qt.gl.surface import GlSurface

from brdf_designer.picture.contents import PictureContents
from brdf_designer.picture.drawer import PictureDrawer
from brdf_suite.realtime.gl.context import Context

if TYPE_CHECKING:
    from brdf_designer.picture.panel import PicturePanel


def make_surface(
    contents: PictureContents,
    panel: PicturePanel,
    made: Callable[[PictureDrawer], None],
    better: Callable[[], None],
) -> GlSurface:
    """Return the widget that draws ``contents``; ``made`` is called with the drawer of each new context.

    ``panel`` gives the grey that is shown before there is a picture; ``better`` is called when the same contents would
    be drawn with better weights.
    """

    def make(context: Context) -> PictureDrawer:
        drawer = PictureDrawer(context, contents, panel.grey, better)
        made(drawer)
        return drawer

    # The renderer averages its samples by itself, in linear light.
    return GlSurface(make, samples=0)
