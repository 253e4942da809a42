"""Step 4: sphere and lamp."""
