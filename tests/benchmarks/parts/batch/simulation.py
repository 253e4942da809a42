"""Discrete simulation of a batch on many workers, from costs that were measured on one core.

What is simulated: the process that runs the batch hands out groups, one after the other, and takes back what they came
to; the scheduler needs its time for each of them; workers do one group at a time and always have the next at hand. The
results are written at the end, by one process.
"""

from __future__ import annotations

import heapq
from typing import NamedTuple

import numpy as np


class Costs(NamedTuple):
    """Seconds on one core, and bytes.

    Attributes
    ----------
    item_s
        What single items took, (n,): groups are drawn from these.
    open_s
        Of a worker before its first item.
    task_s
        Of the scheduler and the client for a task, whatever is in it.
    append_s
        Of the journal for a group, beside its rows.
    row_s
        Of the client for a row: journal, and tables at the end.
    item_bytes, row_bytes
        What goes to a worker for an item, and what comes back.
    """

    item_s: tuple[float, ...]
    open_s: float
    task_s: float
    append_s: float
    row_s: float
    item_bytes: float
    row_bytes: float


class Simulated(NamedTuple):
    """Hours, the share of the workers' time in which they worked, the busiest share of the client, and what limits."""

    hours: float
    workers_busy: float
    client_busy: float
    megabytes_per_s: float

    @property
    def bottleneck(self) -> str:
        """What would have to be faster first."""
        return "client and scheduler" if self.client_busy > self.workers_busy else "workers"


def simulate(costs: Costs, items: int, workers: int, group: int, ahead: int = 3, seed: int = 0) -> Simulated:
    """Return what a batch of ``items`` comes to on ``workers`` in groups of ``group``.

    The client is one server: handing a group out and taking it back keep it busy. A worker gets the next group when it
    has one of its ``ahead`` places free, so it waits only where the client is late.
    """
    rng = np.random.default_rng(seed)
    item_s = np.asarray(costs.item_s)
    groups = -(-items // group)
    lengths = np.full(groups, group)
    lengths[-1] = items - group * (groups - 1)
    # The sum of many draws: mean and variance say all of it.
    work = np.maximum(
        lengths * item_s.mean() + np.sqrt(lengths) * item_s.std() * rng.standard_normal(groups), 1e-6
    )
    client = busy = 0.0
    free = [costs.open_s] * workers
    back: list[tuple[float, int]] = []
    handed = done = 0
    while done < groups:
        if handed < groups and handed - done < ahead * workers:
            client += 0.5 * costs.task_s
            start = max(client, heapq.heappop(free))
            end = start + float(work[handed])
            busy += float(work[handed])
            heapq.heappush(free, end)
            heapq.heappush(back, (end, handed))
            handed += 1
            continue
        end, which = heapq.heappop(back)
        client = (
            max(client, end) + 0.5 * costs.task_s + costs.append_s + 0.5 * costs.row_s * int(lengths[which])
        )
        done += 1
    tail = 0.5 * costs.row_s * items
    total = client + tail
    spent = groups * (costs.task_s + costs.append_s) + items * costs.row_s
    moved = items * (costs.item_bytes + costs.row_bytes)
    return Simulated(total / 3600.0, busy / (workers * total), spent / total, moved / total / 1e6)
