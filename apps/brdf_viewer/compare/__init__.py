"""The second paint and the comparison with it."""
