"""Fields of the inspector, and the meanings of their numbers."""
