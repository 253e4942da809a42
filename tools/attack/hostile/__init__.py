"""Programs started in hostile surroundings: files, names, variables, folders, limits."""
