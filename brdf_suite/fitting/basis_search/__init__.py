"""The search for the fixed exponents that fit a database of paints best (seed paper, section 3.2)."""
