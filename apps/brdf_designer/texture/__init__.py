"""Sparkle and graininess of a paint as the virtual instrument reads them, and flakes for wanted readings."""
