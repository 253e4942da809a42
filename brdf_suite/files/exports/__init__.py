"""Export of paints to other programs: a registry of formats, each with the losses of its conversion."""

from brdf_suite.files.exports.format import ExportFormat, ExportItem, ImportedPaints, Spectra
from brdf_suite.files.exports.registry import FORMATS, read_paints

__all__ = ["FORMATS", "ExportFormat", "ExportItem", "ImportedPaints", "Spectra", "read_paints"]
