"""The swatches of a pane as a grid or a list."""
