"""Selection of the Mitsuba variant: CUDA on NVIDIA graphics cards, LLVM on processors, or none, with the reason.

A variant is tried in a process of its own first (:mod:`.probe`): with an LLVM that is too old, compiling aborts the
whole process, and no exception can be caught. What is found is kept for the life of this process.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from brdf_suite import variables
from brdf_suite.errors import ExtraError, ReferenceUnavailableError
from brdf_suite.extras import check_extra, import_extra
from brdf_suite.processes import child_command

OLDEST_LLVM = 17
"""LLVM 14 to 16 abort in the middle of a compilation."""
LLVM_PACKAGE = "libllvm19"
SCALAR = "scalar_rgb"
PROBE_TIMEOUT_S = 300.0
NOT_LOADED = 3
"""Exit status of a trial that could not load Mitsuba; it prints the reason as JSON."""

_PLACES = (
    "usr/lib/*/libLLVM*.so*",
    "usr/lib/llvm-*/lib/libLLVM*.so*",
    "usr/lib64/libLLVM*.so*",
    "usr/local/lib/libLLVM*.so*",
    "opt/homebrew/opt/llvm*/lib/libLLVM*.dylib",
    "usr/local/opt/llvm*/lib/libLLVM*.dylib",
)
_CUDA_DRIVERS = ("/proc/driver/nvidia/version", "C:/Windows/System32/nvcuda.dll")
_VERSION = re.compile(r"(?:llvm-|libLLVM[-.]|so\.)(\d+)")


@dataclass(frozen=True)
class Variant:
    """A working variant of Mitsuba; ``llvm_path`` is the library that it needs, "" where it needs none."""

    name: str
    llvm_path: str = ""
    version: str = ""
    instead: str = ""
    """Why it is the scalar one: what is missing, and what to install."""

    @property
    def is_scalar(self) -> bool:
        """Whether only Mitsuba's own plug-ins run: every reflectance is then given as a table."""
        return self.name.startswith("scalar")

    @property
    def title(self) -> str:
        """Notice for the user."""
        if self.is_scalar:
            return "Mitsuba, without LLVM"
        return f"Mitsuba, {'CUDA' if self.name.startswith('cuda') else f'LLVM {self.version}'}"


@dataclass(frozen=True)
class ProbeResult:
    """Result of a probe: whether it ran, the LLVM version, and the last words of its error."""

    ran: bool
    version: str = ""
    words: str = ""


Probe = Callable[[str, str], ProbeResult]


@cache
def choose_variant() -> Variant:
    """Return the variant to render with.

    Raises
    ------
    ExtraError
        Mitsuba is missing, too old, or cannot be loaded.
    ReferenceUnavailableError
        There is neither an LLVM of 17 or later nor a graphics card that can be used; the message names the package to
        install.
    """
    check_extra("mitsuba", purpose="path tracing")
    # Without NVIDIA's driver the variant is not worth the seconds of a trial.
    return choose(any(Path(place).exists() for place in _CUDA_DRIVERS), _libraries(), probe)


def choose(cuda: bool, libraries: Sequence[str], try_out: Probe) -> Variant:
    """Return the first variant that ``try_out`` sees running: CUDA, then LLVM, each of ``libraries`` in their order."""
    findings = []
    if cuda:
        found = try_out("cuda_ad_rgb", "")
        if found.ran:
            return Variant("cuda_ad_rgb")
        findings.append(f"CUDA: {found.words}")
    for path in libraries:
        number = parse_version(path)
        if number and number < OLDEST_LLVM:
            findings.append(f"{path} is LLVM {number}")
            continue
        found = try_out("llvm_ad_rgb", path)
        if found.ran:
            return Variant("llvm_ad_rgb", path, found.version)
        findings.append(f"{path}: {found.words}")
    seen = f" Found: {'; '.join(findings)}." if findings else ""
    raise ReferenceUnavailableError(
        f"The reference renderer needs the library LLVM, version {OLDEST_LLVM} or later; install the package "
        f"{LLVM_PACKAGE} (sudo apt-get install {LLVM_PACKAGE}), or set {variables.LLVM} to the library's file.{seen}"
    )


def probe(variant: str, llvm_path: str) -> ProbeResult:
    """Try a variant in a process of its own; :class:`ExtraError` where Mitsuba cannot be loaded there."""
    environment = dict(os.environ)
    if llvm_path:
        environment[variables.LLVM] = llvm_path
    try:
        done = subprocess.run(  # noqa: S603 - a module of ours
            child_command("brdf_suite.reference.probe", variant),
            env=environment,
            capture_output=True,
            text=True,
            timeout=PROBE_TIMEOUT_S,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        return ProbeResult(False, words=f"the trial could not be made ({error})")
    if done.returncode == 0:
        return ProbeResult(True, version=str(json.loads(done.stdout.splitlines()[-1])["llvm"]))
    if done.returncode == NOT_LOADED:
        raise ExtraError(str(json.loads(done.stdout.splitlines()[-1])["reason"]))
    lines = done.stderr.strip().splitlines()
    ended = f"ended with signal {-done.returncode}" if done.returncode < 0 else "failed"
    return ProbeResult(False, words=f"its trial {ended} ({lines[-1] if lines else 'without a word'})")


def parse_version(path: str) -> int:
    """Return the LLVM version from a library's name; 0 where it has none.

    >>> parse_version("usr/lib/x86_64-linux-gnu/libLLVM.so.19.1"), parse_version("usr/lib/libLLVM.so")
    (19, 0)
    """
    numbers = [int(number) for number in _VERSION.findall(path)]
    return max(numbers, default=0)


def _libraries() -> list[str]:
    """Return the library named by the user, alone; else those of the usual places, newest first."""
    named = os.environ.get(variables.LLVM)
    if named:
        return [named]
    found = {str(path.resolve()) for place in _PLACES for path in Path("/").glob(place)}
    return sorted(found, key=lambda path: (-parse_version(path), path))


def prepare_library() -> None:
    """Choose the variant before Dr.Jit is imported: it looks for the library LLVM then, once. Errors are ExtraError."""
    with suppress(ReferenceUnavailableError):
        _name_library(choose_variant())


def _name_library(variant: Variant) -> None:
    if variant.llvm_path:
        os.environ[variables.LLVM] = variant.llvm_path


def start(*, scalar: bool = False) -> Variant:
    """Choose the variant, once per process, and activate it in Mitsuba. Errors as :func:`choose_variant`.

    With ``scalar``, where neither LLVM nor a graphics card can be used, it is the scalar variant, which needs neither.
    """
    try:
        variant = choose_variant()
    except ReferenceUnavailableError as error:
        if not scalar:
            raise
        variant = Variant(SCALAR, instead=str(error))
    _name_library(variant)
    mi = import_extra("mitsuba", purpose="path tracing")
    if mi.variant() != variant.name:  # none yet, or what other code in this process has chosen
        mi.set_variant(variant.name)
    mi.set_log_level(mi.LogLevel.Error)
    return variant
