"""Export of a paint to other programs."""
