"""Small pictures of the paint."""
