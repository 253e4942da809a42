"""Contact sheets of palettes and folders as a picture or as PDF."""
