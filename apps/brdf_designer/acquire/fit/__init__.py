"""Step 8: lobes fitted to the table."""
