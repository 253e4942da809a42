"""Design of paints: feasible colours, variations, mixtures, starts from measurements, standards."""
