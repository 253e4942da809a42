"""The file formats of paint reports: HTML and PDF."""

from __future__ import annotations

from functools import partial

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.exports import json_document
from brdf_suite.files.exports.format import ExportFormat, ImportedPaints
from brdf_suite.regular_files import read_bytes
from brdf_suite.reports.paint_report import html
from brdf_suite.reports.paint_report.document import Report, ReportOptions, report_losses, write_report

_LARGEST = 64 << 20
_MARK = f'{{"format": "{json_document.NAME}"'.encode()


def report_formats(options: ReportOptions) -> tuple[ExportFormat, ...]:
    """Return the formats in which reports are written, with the options that their writers use."""
    return html.format_with(options), _pdf_format(options)


def _pdf_format(options: ReportOptions) -> ExportFormat:
    return ExportFormat(
        name="pdf",
        title="Report, PDF",
        ending=".pdf",
        holds="One page with pictures, plots and numbers; the paint itself is attached as a file.",
        losses=report_losses,
        write=partial(write_report, options, _pdf_page),
        read=_read_pdf,
        sniff=lambda head: head.startswith(b"%PDF-"),
    )


def _pdf_page(made: Report) -> tuple[bytes, tuple[str, ...]]:
    from brdf_suite.reports.paint_report.pdf import page  # reportlab is much to import, and few files are PDF

    return page(made)


def _read_pdf(path: PathLike) -> ImportedPaints:
    """Return the paint attached to a page of ours; raise :class:`FileError` where there is none, or it is damaged."""
    content = read_bytes(path, _LARGEST)
    start = content.find(_MARK)
    end = content.find(b"endstream", start)
    if start < 0 or end < 0:
        raise FileError(
            path, "holds no paint of this suite that can be found; another program may have packed it"
        )
    return json_document.import_text(content[start:end], path)
