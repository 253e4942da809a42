"""A palette is written as CxF3, read back, searched, and written for programs that know flat colours only."""

import brdf_suite as bs

entries = (bs.Entry(bs.load(name, bs.Paint)) for name in ("blue", "fine_silver", "solid_black"))
bs.save(bs.Palette("Three", tuple(entries)), "three.cxf")
three = bs.load("three.cxf", bs.Palette)
print([(near.entry.name, near.delta_e) for near in bs.find_nearest("blue", three)])
print(bs.save(three, "three.ase"))  # what the format cannot hold
