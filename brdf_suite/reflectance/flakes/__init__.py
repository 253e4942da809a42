"""Single flakes: visibility in a pixel, tilt, and brightness relative to the mean.

The functions of the shaders ``sparkle_hash``, ``flake_footprint``, ``flake_tilt``, ``flake_tint``, ``sparkle_glints``
and ``flake_texture`` in numpy, with the same names and the same hash, so that a flake is the same one in both.
"""
