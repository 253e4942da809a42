"""Random events in the real programs."""
