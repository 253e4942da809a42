"""Commands on palettes."""
