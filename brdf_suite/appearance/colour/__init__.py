"""Colour spaces: colorimetry, spectra, screens, flat colours."""
