"""Search for swatches: by colour, by filters, and two of them compared."""
