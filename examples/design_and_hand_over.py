"""A paint is designed by its colours per aspecular angle, rendered, and handed over as CxF3."""

import brdf_suite as bs

flop = {15: (62, -4, -45), 45: (25, 4, -38), 110: (9, 8, -28)}  # degrees: L*, a*, b*
sea = bs.Paint("Sea", tuple(bs.Measurement(45, at, lab) for at, lab in flop.items()), bs.Gloss(90))
print(bs.fit(sea).worst_delta_e, bs.measure(sea).gloss, bs.save(sea, "sea.brdfpaint"))
print(bs.export(sea, "sea.cxf").losses)
bs.render(sea, "sea.png", size=(160, 120), environment="overcast")
