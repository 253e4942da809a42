"""Flop index, travel, and edits of the flop."""
