"""``brdf-suite fit PAINT``: lobe weights of any reflectance, their errors, and the fit time."""

from __future__ import annotations

import argparse
import math

import numpy as np
from numpy.typing import NDArray

from brdf_suite.cli.arguments import PAINT, add_arguments, add_json
from brdf_suite.cli.fit_options import add_fitting, parse_basis_alone, parse_fitting
from brdf_suite.cli.output import print_csv, print_json, print_notes, progress_bar
from brdf_suite.command_parser import CommandParser
from brdf_suite.fitting.metrics import ErrorFigures
from brdf_suite.inspection.angle_fit import fit_at_angles, judged_gammas
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Fit the fixed set of cosine lobes, or one of your own, to a paint of any kind or a measured file. "
        "Weights are linear Rec. 2020, f_r·cosθ at the stated incidence: KD and KDD times N·L, KG without. Errors are "
        "those of the fit (L1) and those where the fit did not look."
    )
    add_arguments(
        command,
        {
            "paint PAINT": PAINT,
            "--angles K": "fit a designed or Cook-Torrance paint at K incidences (3 or more; 16 is usual) with "
            "weights that change calmly between them, and report the errors at other incidences",
        },
    )
    add_json(command, csv=True)
    command.examples = ("brdf-suite fit blue", "brdf-suite fit paint.brdf --lobe-count 8 --csv > weights.csv")
    add_fitting(command)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Fit and print."""
    if options.angles is not None:
        return _at_angles(options)

    with progress_bar("fitting", quiet=options.json) as progress:
        settings = parse_fitting(options)
        found = fit_material(load_material(options.paint), settings, errors=True, progress=progress)
    if options.json:
        print_json(found.to_json())
        return 0
    weights = found.weights
    if options.csv:
        rows = zip(weights.exponents, weights.kdd, weights.kg, strict=True)
        print_csv({"exponent": at, **_named("kdd", base), **_named("kg", gloss)} for at, base, gloss in rows)
        return 0
    print(
        f"{found.name}: {len(weights.exponents)} lobes, {found.fit_seconds * 1e3:.2f} ms"
        + (", time-limited" if found.time_limited else "")
    )
    print(f"{'exponent':>17}  {'KDD r':>11}{'g':>10}{'b':>10} {'KG r':>11}{'g':>10}{'b':>10}")
    for exponent, base, gloss in zip(weights.exponents, weights.kdd, weights.kg, strict=True):
        print(f"{exponent:17,.1f}  {_triple(base)} {_triple(gloss)}")
    print(f"               KD  {_triple(weights.kd)}")
    if found.readings:
        print(" aspecular °    L* asked   fitted      ΔE00")
        for row in found.readings:
            print(
                f"{row.aspecular_deg:12.0f}  {row.lab[0]:10.2f} {row.lab_fitted[0]:8.2f}  {row.delta_e_2000:8.3f}"
            )
    elif found.angles:
        print("     light °  aspecular °          L*   fitted      ΔE00")
        for row in found.angles:
            print(
                f"{row.illumination_deg:12.1f} {row.aspecular_deg:12.1f}  {row.lab[0]:10.2f} {row.lab_fitted[0]:8.2f}  "
                f"{row.delta_e_2000:8.3f}" + ("" if row.fitted else "  (not fitted)")
            )
    for part, errors in found.l1_errors.items():
        print(f"L1 error, {part}: " + ", ".join(f"{100.0 * error:.1f} %" for error in errors) + " (R, G, B)")
    if found.held_out is not None:
        print(
            f"where the fit did not look ({found.held_out.pairs:,} direction pairs: {found.held_out.where}):"
        )
        print(
            f"    {_figures(found.held_out.figures)}; {100.0 * found.held_out.relative_rms:.0f} % of the data's own RMS"
        )
        if found.held_out.away is not None:
            print(f"    more than 5° from the mirror direction: {_figures(found.held_out.away)}")
    print_notes(found.notices)
    return 0


def _at_angles(options: argparse.Namespace) -> int:
    found = fit_at_angles(options.paint, options.angles, parse_basis_alone(options, "a fit with --angles"))
    if options.json:
        print_json(found.to_json())
        return 0
    if options.csv:
        print_csv(
            {
                "illumination_deg": row.illumination_deg,
                "aspecular_deg": row.aspecular_deg,
                "delta_e": row.delta_e_2000,
            }
            for row in found.errors
        )
        return 0
    weights = found.weights
    print(
        f"{found.name}: {weights.exponents.size} lobes at {weights.grid.count} incidences, "
        f"{found.fit.seconds * 1e3:.2f} ms" + (", time-limited" if found.fit.time_limited else "")
    )
    print(" incidence °         KD r         g         b   gloss energy r         g         b")
    energy = weights.coat_energy()
    for cosine, kd, gloss in zip(weights.cosines, weights.kd, energy, strict=True):
        print(f"{math.degrees(math.acos(min(cosine, 1.0))):12.1f}  {_triple(kd)}      {_triple(gloss)}")
    gammas = judged_gammas(45.0)
    print("ΔE00 at light °  γ = " + "".join(f"{gamma:8.0f}" for gamma in gammas))
    rows = {(row.illumination_deg, row.aspecular_deg): row.delta_e_2000 for row in found.errors}
    for theta in dict.fromkeys(theta for theta, _ in rows):
        values = (rows.get((theta, gamma)) for gamma in gammas)
        print(f"{theta:15.0f}      " + "".join(f"{'':8}" if v is None else f"{v:8.2f}" for v in values))
    print_notes(found.notices)
    return 0


def _figures(figures: ErrorFigures) -> str:
    return (
        f"cosine-weighted RMS {figures.cosine_rms:.4g} 1/sr, cube-root RMS {figures.cube_root_rms:.4g}, "
        f"log error {figures.log_rms:.4g}"
    )


def _named(name: str, weights: NDArray[np.float64]) -> dict[str, float]:
    return dict(zip((f"{name}_r", f"{name}_g", f"{name}_b"), weights.tolist(), strict=True))


def _triple(weights: NDArray[np.float64]) -> str:
    return f"{weights[0]:11.4f}{weights[1]:10.4f}{weights[2]:10.4f}"
