"""Models written as text: GLSL as in ``.brdf`` files of the BRDF Explorer, or formulas in Python's notation."""
