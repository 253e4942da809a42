"""Cook-Torrance lobes and products of textures for anything that reflects."""
