"""Known layouts of environment images and their descriptions.

All images are taken as seen from inside, not mirrored, unless the layout is a mirror ball, which is seen from
outside. The middle of the front is +z, what is right of it is -x, as in the suite's latitude-longitude maps.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from brdf_suite.documents.view import ImageLayout

Layout = ImageLayout

LAYOUTS: Mapping[Layout, str] = MappingProxyType(
    {
        "latlong": "latitude-longitude map, twice as wide as high",
        "horizontal_cross": "cube unfolded to 4 × 3 faces: left, front, right, back; up and down at the front",
        "vertical_cross": "cube unfolded to 3 × 4 faces: left, front, right; up above, down and back (turned) below",
        "horizontal_strip": "six faces side by side: right, left, up, down, front, back",
        "vertical_strip": "six faces one below the other, in the same order",
        "exr_cube": "six faces one below the other as OpenEXR's cube maps have them",
        "angular": "light probe: the angle from the front grows evenly with the radius, the rim is the back",
        "mirror_ball": "photograph of a mirror ball from far away, the camera in front of it (+z)",
        "dome": "fisheye of the upper half: the zenith in the middle, the horizon at the rim, the front below",
    }
)
