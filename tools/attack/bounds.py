"""What the figures of a run may be at most, and at least."""

from __future__ import annotations

HANG_S = 5.0
"""Of processor time for one input, or for one turn of the event loop."""
OUTSIDE_HANG_S = 1.0
"""The same in a library that has a process of its own, which is ended: that is counted, and is no fault."""
MOST_GROWTH = 0.10
"""Of the memory of a program in a working day."""
SHORTEST_VERDICT = 0.2
"""From this scale on histories and pools of threads are full in the middle, and memory and threads count."""
OLDEST_S, STALL_MS = 0.5, 50.0
"""In a flood on the link: the age of values at their delivery, and turns of the event loop."""
LEAST_INPUTS, LEAST_OF_A_READER, LEAST_KILLS, LEAST_LINES = 1_000_000, 20_000, 1_000, 300
"""What a long run has at least: damaged inputs in all and of each reader, kills of writers, command lines."""
