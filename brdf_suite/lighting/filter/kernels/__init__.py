"""The compiled loops of the filter."""
