"""Materials on the GPU."""
