"""The reflected distribution of one incidence as a radial surface."""
