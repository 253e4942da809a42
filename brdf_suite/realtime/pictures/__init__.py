"""Frames and pictures: renderer, tone curves, comparison, captured forms."""
