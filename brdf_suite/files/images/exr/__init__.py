"""OpenEXR: header check, channels, reading and writing."""
