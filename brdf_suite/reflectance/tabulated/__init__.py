"""Measured reflectance as arrays: half-angle tables, four-angle tables, scattered samples. No file is read here."""
