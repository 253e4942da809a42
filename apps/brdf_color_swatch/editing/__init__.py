"""Edits of swatches: the Edit menu, groups, clipboard, drops and order."""
