"""Measured reflectance: every file format behind :func:`read_measured` and :func:`write_measured`."""

from brdf_suite.files.measured.format import (
    MeasuredFormat,
    MeasuredReflectance,
    ReadOptions,
    WrittenMeasurement,
)
from brdf_suite.files.measured.registry import FORMATS, read_measured, sniff, write_measured

__all__ = [
    "FORMATS",
    "MeasuredFormat",
    "MeasuredReflectance",
    "ReadOptions",
    "WrittenMeasurement",
    "read_measured",
    "sniff",
    "write_measured",
]
