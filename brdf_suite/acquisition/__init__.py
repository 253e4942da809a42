"""From photographs of a painted sphere to a table of its reflectance (Günther et al. 2005, sections 3 and 4.1)."""
