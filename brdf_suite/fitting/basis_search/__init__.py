"""Search for the fixed exponents that best fit a database of paints (Westlund and Meyer, section 3.2)."""
