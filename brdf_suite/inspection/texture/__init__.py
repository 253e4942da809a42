"""The virtual texture instrument: sparkle in directed light, graininess in diffuse light, and flakes from readings."""
