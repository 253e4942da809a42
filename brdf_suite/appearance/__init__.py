"""Colour and gloss as the paint trade measures them: colorimetry, differences, flop, gloss."""
