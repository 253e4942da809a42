"""The direction of the light."""
