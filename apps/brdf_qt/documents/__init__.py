"""Open documents: files, undo, recovery, watching."""
