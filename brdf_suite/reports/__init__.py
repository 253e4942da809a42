"""Documents about paints: paint reports, contact sheets, hand-over to other programs."""
