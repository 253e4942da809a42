"""The file formats of paint reports: HTML and PDF."""

from __future__ import annotations

from brdf_suite.files.exports.format import ExportFormat
from brdf_suite.reports.paint_report import html, pdf
from brdf_suite.reports.paint_report.document import ReportOptions


def report_formats(options: ReportOptions) -> tuple[ExportFormat, ...]:
    """Return the formats in which reports are written, with the options that their writers use."""
    return html.format_with(options), pdf.format_with(options)
