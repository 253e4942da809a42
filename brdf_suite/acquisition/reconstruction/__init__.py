"""The steps of a reconstruction, from photographs to a table."""
