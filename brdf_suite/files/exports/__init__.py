"""Export of paints to other programs: a registry of formats, each with the losses of its conversion."""

from brdf_suite.files.exports.format import ExportFormat, ImportedPaints, Spectra, Subject
from brdf_suite.files.exports.registry import FORMATS, read_paints

__all__ = ["FORMATS", "ExportFormat", "ImportedPaints", "Spectra", "Subject", "read_paints"]
