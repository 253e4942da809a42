"""Where the sphere is in the photographs: outline, highlight, axis."""
