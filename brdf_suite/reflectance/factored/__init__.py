"""Products of textures as reflectances."""
