"""Step 5: the mask."""
