"""Choosing paints, lights and forms by their pictures."""
