"""Texts and figures over the picture."""
