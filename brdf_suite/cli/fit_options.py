"""Command-line options that say how lobes are fitted: basis, number of lobes, weighting and diffuse term."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from brdf_suite.cli.arguments import add_arguments, whole_number
from brdf_suite.command_parser import CommandParser
from brdf_suite.errors import SuiteError

if TYPE_CHECKING:  # they load numpy, which `render` must set up first
    from brdf_suite.fitting.lobes.basis import LobeBasis
    from brdf_suite.fitting.lobes.program import Weighting
    from brdf_suite.fitting.lobes.settings import FitSettings

FITTING = ("basis", "lobe_count", "weighting", "diffuse")
"""The names of all options of this module: those of commands that fit lobes."""


def add_basis(command: CommandParser) -> argparse._ArgumentGroup:
    """Declare the options read by :func:`parse_basis`; return their group."""
    lobes = command.add_argument_group("lobes")
    add_arguments(
        lobes,
        {
            "--basis FILE": "the lobes' exponents: a file written by `brdf-suite basis` (default: the suite's own)",
            "--lobe-count N": "how many lobes, of the counts in that file (default: the file's own default)",
        },
        lobe_count=whole_number(1, 12),
    )
    return lobes


def add_fitting(command: CommandParser) -> None:
    """Declare the options read by :func:`parse_fitting`."""
    add_arguments(
        add_basis(command),
        {
            "--weighting": "paints with layers: how much a sample counts: absolute (the default), relative to the "
            "reflectance, or by its solid angle",
            "--diffuse": "paints with layers: fit the diffuse term with the lobes (joint, the default), or take it as "
            "measured at 110° from the mirror direction",
        },
        weighting=("absolute", "relative", "solid-angle"),
        diffuse=("joint", "measured"),
    )


def parse_basis(options: argparse.Namespace) -> LobeBasis:
    """Return the basis that the options ask for.

    Raises :class:`SuiteError`: the file cannot be read, is no basis, or has none of so many lobes.
    """
    from brdf_suite.fitting.lobes.basis import read_basis, shipped_basis

    if options.basis is None:
        return shipped_basis(options.lobe_count)
    return read_basis(options.basis, options.lobe_count)


def parse_fitting(options: argparse.Namespace) -> FitSettings:
    """Return the settings that the options ask for; errors as :func:`parse_basis`."""
    from brdf_suite.fitting.lobes.settings import FitSettings

    given = options.weighting
    weighting: Weighting = "solid angle" if given == "solid-angle" else given or "absolute"
    return FitSettings(parse_basis(options), weighting, options.diffuse or "joint")


def parse_basis_alone(options: argparse.Namespace, what: str) -> LobeBasis:
    """Return the basis for ``what``, which has weights and a diffuse term of its own; refuse a choice of those."""
    for name in ("weighting", "diffuse"):
        if vars(options)[name] is not None:
            raise SuiteError(f"--{name} is not for {what}; leave it out.")
    return parse_basis(options)
