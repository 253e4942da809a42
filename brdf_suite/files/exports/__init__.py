"""Handing paints over to other programs: every format behind one registry, each with what it cannot hold."""

from brdf_suite.files.exports.format import ExportFormat, ExportItem, Imported, Spectra
from brdf_suite.files.exports.registry import FORMATS, read_paints

__all__ = ["FORMATS", "ExportFormat", "ExportItem", "Imported", "Spectra", "read_paints"]
