"""Fields of the inspector."""
