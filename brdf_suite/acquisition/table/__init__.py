"""From readings to a table of the reflectance."""
