"""Pictures by the ray tracer of Günther et al. 2005."""
