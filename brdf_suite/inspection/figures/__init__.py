"""Figures of reflectances: albedo, energy, colours, and errors between two of them."""
