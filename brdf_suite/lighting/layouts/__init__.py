"""Layouts of environment images, and their conversion to a latitude-longitude map."""

from brdf_suite.lighting.layouts.convert import as_latlong
from brdf_suite.lighting.layouts.detect import detect_layout
from brdf_suite.lighting.layouts.names import LAYOUTS, Layout

__all__ = ["LAYOUTS", "Layout", "as_latlong", "detect_layout"]
