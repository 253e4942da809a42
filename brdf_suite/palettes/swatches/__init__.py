"""Pictures of the paints of a palette."""
