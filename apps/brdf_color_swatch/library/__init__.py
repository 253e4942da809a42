"""The library of palettes: files, groups, undo."""
