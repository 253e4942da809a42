"""The colours of a paint: readings, plots, flop."""
