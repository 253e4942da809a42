"""Options of the command line that say how a run without a user looks: the light, the radius, what is shown."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, get_args

from brdf_qt.window.fit_choice import FitChoice

from brdf_lobe_visualizer.options import CHANNELS, COSINES, RADII, SHOWN, Shown
from brdf_suite.fitting.lobes.basis import MOST_LOBES
from brdf_suite.fitting.lobes.program import Weighting
from brdf_suite.fitting.lobes.settings import Diffuse

if TYPE_CHECKING:
    from brdf_lobe_visualizer.assembly import LobeVisualizer


def add_options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    view = parser.add_argument_group("the view of this run")
    light = "direction of the light in degrees, such as 45,0 or 60,90"
    view.add_argument("--incidence", type=incidence, metavar="THETA,PHI", help=light)
    view.add_argument("--radius", choices=RADII, help="mapping from values to radii")
    view.add_argument("--channel", choices=CHANNELS, help="channel of surface colours and plots")
    cosine = "cosines that multiply f_r: light (N·L), both (N·L and N·V) or none"
    view.add_argument("--cosine", choices=COSINES, help=cosine)
    what = "target, fit, both (target,fit), side-by-side or difference"
    view.add_argument("--show", type=shown, metavar="WHAT", help=what)
    view.add_argument("--no-gloss", action="store_true", help="leave the gloss out of targets and fits")
    view.add_argument("--reference", type=int, metavar="N", help="index of the reference, from 1")
    view.add_argument("--front", type=int, metavar="N", help="index of the selected reflectance, from 1")
    what = "show the selected reflectance as cosine lobes, Cook-Torrance lobes and homomorphic factors too"
    view.add_argument("--representations", action="store_true", help=what)
    view.add_argument("--plots", metavar="KEY,KEY", help="visible plots; all others are hidden")
    view.add_argument("--panels", metavar="KEY,KEY", help="visible panels: numbers, reflectances, factors")
    view.add_argument("--no-inspector", action="store_true", help="hide the inspector")
    option = "option of a view or panel; repeatable"
    view.add_argument("--set", action="append", default=[], type=_pair, metavar="KEY=VALUE", help=option)


def add_fit(parser: argparse.ArgumentParser) -> None:
    """Declare the options read by :func:`parse_fit`."""
    fit = parser.add_argument_group("the fit of this run")
    fit.add_argument("--basis", default="", metavar="FILE", help="exponents: a file of brdf-suite basis")
    most = f"number of lobes, 1 to {MOST_LOBES}, of those that the basis was searched for"
    fit.add_argument("--lobe-count", type=int, choices=range(1, MOST_LOBES + 1), metavar="N", help=most)
    words = tuple(word.replace(" ", "-") for word in get_args(Weighting))
    fit.add_argument("--weighting", choices=words, help="weights of the samples")
    where = "diffuse term: fitted with the lobes, or measured off the mirror direction"
    fit.add_argument("--diffuse", choices=get_args(Diffuse), help=where)


def parse_fit(options: argparse.Namespace) -> FitChoice | None:
    """Return the choice for this run; None where no option makes one."""
    if not (options.basis or options.lobe_count or options.weighting or options.diffuse):
        return None
    given = options.weighting
    weighting: Weighting = "solid angle" if given == "solid-angle" else given or "absolute"
    return FitChoice(options.basis, options.lobe_count or 0, weighting, options.diffuse or "joint")


def incidence(text: str) -> tuple[float, float]:
    """Parse ``THETA,PHI`` in degrees (an argparse type); the azimuth may be left out."""
    parts = text.split(",")
    try:
        theta, phi = float(parts[0]), float(parts[1]) if len(parts) > 1 else 0.0
    except ValueError:
        theta = phi = float("nan")
    if len(parts) > 2 or not 0.0 <= theta < 90.0 or not abs(phi) <= 360.0:
        raise argparse.ArgumentTypeError(
            f"{text!r} is no incidence; give a polar angle below 90 and an azimuth, as in 45,0"
        )
    return theta, phi


def shown(text: str) -> Shown:
    """Parse what is shown of each reflectance (an argparse type)."""
    words = frozenset(text.replace("-", " ").split(","))
    if words == {"target", "fit"}:
        return "both"
    word = next(iter(words))
    if len(words) != 1 or word not in SHOWN:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not shown; give target, fit, target,fit, side-by-side or difference"
        )
    return word


def apply_view(program: LobeVisualizer, options: argparse.Namespace) -> None:
    """Set what the options ask for and no subject is needed for; call before the window is shown."""
    session, window = program.session, program.window
    wanted = {name: getattr(options, name) for name in ("radius", "channel", "cosine")}
    if options.show is not None:
        wanted["shown"] = options.show
    if options.no_gloss:
        wanted["gloss"] = False
    session.set_options(**{name: value for name, value in wanted.items() if value is not None})
    if options.incidence is not None:
        session.set_incidence(*options.incidence)
    if options.plots is not None:
        keys = options.plots.split(",") if options.plots else []
        for key in window.plots.plots:
            window.plots.set_shown(key, key in keys, remember=False)
    for key in (options.panels or "").split(","):
        if key in window.docks:
            window.docks[key].show()
    if options.no_inspector:
        window.inspector_dock.hide()
    for key, value in options.set:
        if not program.do(f"{key}={value}"):
            raise SystemExit(f"brdf-lobes: --set {key}={value}: no view has this option.")


def apply_subjects(program: LobeVisualizer, options: argparse.Namespace) -> None:
    """Choose front and reference by their places, once the subjects are there."""
    subjects = program.session.subjects
    session = program.session
    for number, choose in ((options.front, session.set_front), (options.reference, session.set_reference)):
        if number is not None and 1 <= number <= len(subjects):
            choose(subjects[number - 1].key)
    if options.representations:
        program.add_representations()


def _pair(text: str) -> tuple[str, str]:
    key, found, value = text.partition("=")
    if not found or not key:
        raise argparse.ArgumentTypeError(f"{text!r} sets nothing; give KEY=VALUE")
    return key, value
