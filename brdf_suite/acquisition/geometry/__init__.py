"""Camera and lens, and where sphere, turntable and light are."""
