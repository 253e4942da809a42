"""From an environment to prefiltered lobe maps."""
