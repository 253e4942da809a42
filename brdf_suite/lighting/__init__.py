"""Light: environments, cube maps, prefiltered lobe maps and their cache."""
