"""Lobe Visualizer: the program in which reflectances are looked at, in three dimensions, in slices and in numbers."""
