"""Pictures of swatches."""
