"""Figures of the subjects and the plot of the albedo."""
