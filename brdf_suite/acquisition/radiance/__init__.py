"""From a series of exposures to radiances: merging, dark frame, flat field, white reference."""
