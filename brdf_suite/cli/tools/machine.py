"""Description of the machine that figures were measured on."""

from __future__ import annotations

import os
import platform
from functools import cache
from pathlib import Path

from brdf_suite.errors import GraphicsError
from brdf_suite.pipeline.picture import gl_renderer_name


@cache
def describe_machine() -> dict[str, object]:
    """Return processor, cores that this process may use, memory in GiB, system, Python and GL renderer."""
    return {
        "processor": _processor(),
        "cores": len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count(),
        "memory_gib": _memory_gib(),
        "system": f"{platform.system()} {platform.machine()}",
        "python": platform.python_version(),
        "gl_renderer": _gl_renderer(),
    }


def machine_summary() -> str:
    """Return the machine in one short line."""
    machine = describe_machine()
    return f"{machine['processor']}, {machine['cores']} cores, {machine['gl_renderer']}"


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    names = (line.partition(":")[2].strip() for line in lines if line.startswith("model name"))
    return next(names, platform.machine())


def _memory_gib() -> float | None:
    if not hasattr(os, "sysconf") or "SC_PHYS_PAGES" not in os.sysconf_names:
        return None
    return round(os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / 2**30, 1)


def _gl_renderer() -> str:
    try:
        return gl_renderer_name()
    except GraphicsError as error:
        return f"none: {error}"
