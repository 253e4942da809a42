"""Sphere, turntable and light refined together from all highlights."""
