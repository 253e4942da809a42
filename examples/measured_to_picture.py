"""A measured file becomes lobes, their plot, and a picture."""

import brdf_suite as bs

bs.convert("blue", "measured.binary")  # stands for a file of the MERL database; any measured format is read
lobes = bs.fit("measured.binary")
print("largest ΔE00 at the usual angles:", lobes.worst_delta_e, *lobes.notices)
bs.plot(lobes).save("lobes.svg")
bs.render(lobes, "measured.png", size=(160, 120), environment="overcast")
