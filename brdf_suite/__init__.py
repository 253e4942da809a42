"""Core library of BRDF Suite: the computations of the four programs, without any window.

Rooms, from the bottom: ``geometry``, ``documents``, ``appearance``, ``reflectance``, ``surface``, ``files``,
``lighting`` and ``fitting``, ``realtime``, ``pipeline``; each imports only from those before it. ``pipeline`` is
where to start.
"""
