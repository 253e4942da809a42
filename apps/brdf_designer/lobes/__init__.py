"""The lobes of the paint over the picture."""
