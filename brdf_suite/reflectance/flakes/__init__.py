"""Flakes one by one: which are seen in a pixel, how they are tilted, and how bright they are over their mean.

The functions of the shaders ``sparkle_hash``, ``flake_footprint``, ``flake_tilt``, ``flake_tint``, ``sparkle_glints``
and ``flake_texture`` in numpy, with the same names and the same hash, so that a flake is the same one in both.
"""
