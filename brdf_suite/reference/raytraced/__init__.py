"""Car-paint ray tracer of Günther et al. 2005, a vectorised integrator on Mitsuba's ray tracing.

The environment is l directional lights (equation 4), whose shadows are traced; the narrow lobes are sampled by s
reflected rays (equation 5); p samples a pixel share lights and rays out among themselves (section 5.3). Nothing here
but :mod:`.quality` may be imported before a variant of Mitsuba has been started.
"""
