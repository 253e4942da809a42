"""The response of a camera."""
