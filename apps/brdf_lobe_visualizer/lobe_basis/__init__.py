"""The lobe basis: exponents, errors, search."""
