"""Programs for development; not in the wheel."""
