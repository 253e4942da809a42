"""Step 3: the response of the camera."""
