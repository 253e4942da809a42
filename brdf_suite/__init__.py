"""The core of BRDF Suite: everything that the four programs do, without a window.

Rooms, from the bottom: ``geometry``, ``documents``, ``appearance``, ``reflectance``, ``surface``, ``files``,
``lighting`` and ``fitting``, ``realtime``, ``pipeline``; each imports only from those before it. ``pipeline`` is
where to start.
"""
