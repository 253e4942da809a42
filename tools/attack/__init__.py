"""Programs that damage files, kill writers and count what survives."""
