"""The swatches as points in colour space."""
