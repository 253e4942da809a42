"""Single lights on the GPU."""
