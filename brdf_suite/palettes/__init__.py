"""Collections of paints: columns of figures, order, search, duplicates, merging."""
