"""The editor of studios and skies: a panorama to click and drag in, a list of lamps, and fields for each."""
