"""Panels and the bar over the swatches."""
