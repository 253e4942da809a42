"""Reference renderer: Mitsuba 3 path-traces the scene of the real-time renderer, as ground truth.

Mitsuba is an optional extra. Nothing here is imported before it is asked for; :mod:`.variant` says whether it can run.
"""
