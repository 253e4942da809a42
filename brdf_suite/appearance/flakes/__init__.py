"""Single flakes: visibility in a pixel, tilt, and brightness relative to the mean.

The functions of the shaders ``flake_footprint`` and ``flake_tilt`` in numpy, with the same names; those of
``sparkle_hash``, ``flake_tint``, ``sparkle_glints`` and ``flake_texture`` are in ``tools/evaluation/flake_model.py``.
"""
