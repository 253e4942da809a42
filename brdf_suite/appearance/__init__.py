"""Colour and gloss in the paint trade's measures: colorimetry, differences, flop, gloss."""
