"""Step 2: the photographs of one position."""
