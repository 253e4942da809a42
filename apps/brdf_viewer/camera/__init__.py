"""The camera and the turntable."""
