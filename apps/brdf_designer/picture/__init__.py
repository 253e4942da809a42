"""The picture of the paint in the middle of the window, and small ones."""
