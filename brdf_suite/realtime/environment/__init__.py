"""The environment on the GPU: lobe maps, background, ground."""
