"""The maps of a factored reflectance."""
