"""The paint that is shown."""
