"""The search for the fixed exponents that fit a database of paints best (Westlund and Meyer, section 3.2)."""
