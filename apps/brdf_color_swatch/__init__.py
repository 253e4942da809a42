"""Color Swatch: the program that keeps collections of paints."""
