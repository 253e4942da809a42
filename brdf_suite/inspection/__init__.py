"""Look at what reflects: lobe surfaces, slices, figures, sparkle."""
