"""Brightness of a footprint's visible flakes in one light, over their mean: 1 in the limit of many.

After Kemppinen et al., "Glinty NDFs in Constant Time" (SIGGRAPH Asia 2025). Flakes have a place on the surface, N to
the square millimetre, and one on the unit square of tilts. On level l both are cut into cells, 2^l/√N wide on the
surface and 2^-l on the square; a pair of cells holds one flake, jittered within both by a hash of the pair. The level
is such that a footprint ends within two by two cells. Between levels flakes of one appear one by one while the
other's go. Kernels end within the cells visited, so the mean is 1 exactly. Cells of tilts are never smaller than a
flake's own spread; beyond that level one flake represents the M of its pair of cells, its deviation from the mean
over √M. The flakes of a cell of the surface share their place in it.
"""

from __future__ import annotations

APPEARING = 0.2
"""Flakes of a level appear over this range of its weight."""
FLAKE_AREA = 3.0
"""Of the mean: the largest flake's area. Areas are 3 u², u even, so most flakes are small."""
RAREST_TILT = 0.002
FADE_FROM, FADE_TO = 0.75, 2.0
