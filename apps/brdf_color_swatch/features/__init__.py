"""Commands and panels over the swatches: edit, compare, group, search, link."""
