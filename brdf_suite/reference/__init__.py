"""The truth to compare with: Mitsuba 3 path-traces the scene that the real-time renderer draws.

Mitsuba is an optional extra. Nothing here is imported before it is asked for; :mod:`.variant` says whether it can run.
"""
