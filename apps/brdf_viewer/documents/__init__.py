"""Views as files, undo, recent files."""
