"""Color Swatch: the program that manages palettes of paints."""
