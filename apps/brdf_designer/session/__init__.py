"""The paint in front, its edits, and the state that is shown."""
