"""Colour differences, tolerances, and the words of the trade for them."""
