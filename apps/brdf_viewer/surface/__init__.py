"""The surface, its parts and its relief."""
