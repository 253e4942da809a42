"""A standard and the differences from it."""
