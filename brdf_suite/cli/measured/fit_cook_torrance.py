"""``brdf-suite fit-cook-torrance PAINT [-o FILE]``: fit of Cook-Torrance lobes to a measured file."""

from __future__ import annotations

import argparse
import math
from collections.abc import Iterator
from dataclasses import asdict, replace
from pathlib import Path

from numpy import asarray

from brdf_suite.appearance.flakes.lobes import flakes_of_lobes
from brdf_suite.cli.arguments import PAINT, add_arguments, add_json, add_output
from brdf_suite.cli.output import print_csv, print_done, print_json, print_notes, progress_bar
from brdf_suite.command_parser import CommandParser
from brdf_suite.documents.atomic import check_target
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.paint import Flakes
from brdf_suite.documents.store import save_paint
from brdf_suite.errors import FileError, FittingError
from brdf_suite.files.measured.brdftable import write_brdftable
from brdf_suite.fitting.cook_torrance.fit import StartsFile
from brdf_suite.fitting.cook_torrance.reflectance_fit import FileFit, fit_cook_torrance
from brdf_suite.fitting.cook_torrance.result import CookTorranceFit
from brdf_suite.fitting.cook_torrance.samples import FitErrors
from brdf_suite.fitting.cook_torrance.settings import MODELS, Settings
from brdf_suite.pipeline.material import load_material
from brdf_suite.progress import report, subrange

_PAINT, _TABLE = ".brdfpaint", ".brdftable"


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Fit kd and lobes (ks, m, r) to a table, to samples, or to a material of RGL, by the mean of "
        "|log(fit/measured)| (Günther et al. 2005, section 4.2), report the errors and each parameter's uncertainty, "
        "and write a paint that every program opens."
    )
    command.examples = (
        "brdf-suite fit-cook-torrance paint.binary -o paint.brdfpaint --lobes 3",
        "brdf-suite fit-cook-torrance paint.bsdf --model ggx --compare",
    )
    add_arguments(command, {"reflectance PAINT": PAINT})
    add_output(
        command,
        "the .brdfpaint to write; a .brdftable takes any model, tabulated",
        stream=_PAINT,
        required=False,
    )
    add_arguments(
        command,
        {
            "--overwrite": "write over FILE where it exists",
            "--lobes N=3": "1 to 6; default: 3",
            "--model MODEL=cook-torrance": "cook-torrance (default), ggx, or ggx-clearcoat, whose last lobe is a "
            "coat over the rest",
            "--flake-size UM": "give the paint flakes of this mean diameter in µm, tilted as its lobes say and lying "
            "side by side; whether there are any is not in the lobes",
            "--compare": "fit the other models too, and print the errors side by side",
            "--loss LOSS=l1": "l1 (default): |log(fit/measured)|; l2: its square; robust: Cauchy's, deaf to outliers",
            "--starts N=8": "from how many places to search; default: 8",
            "--samples N=6000": "the most to look at; default: 6000",
            "--grazing DEG=80.0": "leave out light or view beyond this angle from the normal; default: 80",
            "--seed N=0": "of the choice of samples and starts",
            "--state STATE": "where finished starts are kept, so that a fit that was broken off goes on; default: "
            "FILE with .starts added, removed when the fit is done",
        },
        flake_size=float,
        state=Path,
    )
    add_json(command, csv=True)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Fit, write the files and print a summary."""
    settings = Settings(
        options.lobes,
        options.model,
        options.loss,
        options.starts,
        options.seed,
        options.samples,
        options.grazing,
    )
    _check_output(options)
    state = options.state
    if state is None and options.output is not None:
        state = options.output.with_name(options.output.name + ".starts")
    others = [model for model in MODELS if model != settings.model] if options.compare else []
    if "ggx-clearcoat" in others and settings.lobes < 2:
        others.remove("ggx-clearcoat")
    with progress_bar("fitting", quiet=options.json) as progress:
        share = 1.0 / (1 + len(others))
        report(progress, 0.0, "reading")
        material = load_material(options.reflectance)
        title = Path(material.name).stem or material.name
        try:
            found = fit_cook_torrance(
                title,
                material.reflectance,
                settings,
                state=state,
                progress=subrange(progress, 0.05 * share, share),
            )
        except FittingError as error:
            raise FittingError(f"{material.name}: {error}") from error
        beside = [
            fit_cook_torrance(
                found.name,
                found.reflectance,
                replace(settings, model=model),  # type: ignore[arg-type] # one of the literals
                progress=subrange(progress, share * (1 + k), share * (2 + k)),
            )
            for k, model in enumerate(others)
        ]
    if options.flake_size is not None and found.paint is not None:
        found = _flaked(found, found.paint, options.flake_size)
    if options.output is not None:
        if found.paint is not None and options.output.suffix.lower() == _PAINT:
            save_paint(found.paint, options.output)
        else:
            write_brdftable(found.fit, options.output)
    if state is not None and options.state is None:
        StartsFile(state).remove()
    rows = [found, *beside]
    if options.json:
        value = found.to_json()
        if beside:
            value["models"] = {row.fit.model.name: asdict(row.errors_within) for row in rows}
        if options.output is not None:
            value["file"] = str(options.output)
        print_json(value)
        return 0
    if options.csv:
        print_csv(_lobe_rows(found.fit))
        print_notes(found.notices)
        return 0
    _print_summary(found)
    if beside:
        print(f"the models side by side, within {settings.grazing_deg:g}°:")
        for row in rows:
            print(f"  {row.fit.model.name:14} {_errors(row.errors_within)}")
    if options.output is not None:
        print_done(f"written to {options.output}")
    return 0


def _flaked(found: FileFit, paint: CookTorrancePaint, size_um: float) -> FileFit:
    flakes = flakes_of_lobes(paint, size_um)
    if flakes is None:
        missing = "no lobe is as wide as the tilts of flakes, so the paint has none; fit more lobes"
        print_notes([missing])
    return replace(found, paint=replace(paint, flakes=flakes))


def _check_output(options: argparse.Namespace) -> None:
    """Refuse before the fit what could not be written after it; raise FileError, FittingError or ValueRangeError."""
    output: Path | None = options.output
    if options.flake_size is not None:
        if output is None or output.suffix.lower() != _PAINT:
            raise FittingError(f"--flake-size: flakes go into a {_PAINT}; name one with -o")
        Flakes(0.0, options.flake_size)  # of a size that flakes can have
    if output is None:
        return
    ending = output.suffix.lower()
    if ending not in (_PAINT, _TABLE):
        raise FileError(
            output, f"lobes go into a {_PAINT}, or tabulated into a {_TABLE}; give it that ending"
        )
    if ending == _PAINT and options.model != "cook-torrance":
        raise FileError(
            output, f"lobes of the model {options.model} are no paint; name a {_TABLE}, or fit cook-torrance"
        )
    check_target(output, overwrite=options.overwrite)


def _print_summary(found: FileFit) -> None:
    fit, errors = found.fit, found.fit.standard_errors
    print(
        f"{found.name}: {fit.samples:,} samples, {fit.model.lobes} lobes of {fit.model.name}, {found.seconds:.1f} s"
    )
    print(f"     kd  {_colour(fit.kd, errors.kd)}")
    for lobe in range(fit.model.lobes):
        print(
            f"  {lobe + 1}  ks  {_colour(fit.ks[lobe], errors.ks[lobe])}   m {_number(fit.m[lobe], errors.m[lobe])}"
            f"   r {_number(fit.r[lobe], errors.r[lobe])}"
        )
    print(f"energy (mean |ln(fit/measured)|) {fit.energy_mean:.4f} where the solver looked")
    print(f"within {fit.settings.grazing_deg:g}° of the normal: {_errors(found.errors_within)}")
    print(f"over everything: {_errors(found.errors)}")
    print_notes(found.notices)


def _lobe_rows(fit: CookTorranceFit) -> Iterator[dict[str, object]]:
    """Yield the numbers of each lobe with their standard errors; the diffuse part is lobe 0, without m and r."""
    errors = fit.standard_errors
    yield {"lobe": 0, **_channels(fit.kd, errors.kd), "m": "", "m_error": "", "r": "", "r_error": ""}
    for k in range(fit.model.lobes):
        shape = {"m": fit.m[k], "m_error": errors.m[k], "r": fit.r[k], "r_error": errors.r[k]}
        plain = {name: float(value) for name, value in shape.items()}
        yield {"lobe": k + 1, **_channels(fit.ks[k], errors.ks[k]), **plain}


def _channels(values: object, errors: object) -> dict[str, object]:
    pairs = zip(("red", "green", "blue"), asarray(values).tolist(), asarray(errors).tolist(), strict=True)
    return {
        key: number
        for name, value, error in pairs
        for key, number in ((name, value), (f"{name}_error", error))
    }


def _errors(errors: FitErrors) -> str:
    return (
        f"mean |ln| {errors.l1_mean:.4f}, log RMS {errors.log_rms:.4f}, median {100.0 * errors.median_relative:.2f} %"
        f" of {errors.compared:,} values"
    )


def _colour(values: object, errors: object) -> str:
    pairs = zip(asarray(values).tolist(), asarray(errors).tolist(), strict=True)
    return "  ".join(_number(value, error) for value, error in pairs)


def _number(value: float, error: float) -> str:
    uncertainty = f" ± {error:<8.2g}" if math.isfinite(error) else "           "
    return f"{value:9.4g}{uncertainty}"
