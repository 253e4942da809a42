"""Options of the command line that say how a run without a user looks: the light, the radius, what is shown."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from brdf_lobe_visualizer.options import CHANNELS, COSINES, RADII, SHOWN, Shown

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
    view.add_argument("--reference", type=int, metavar="N", help="index of the reference, from 1")
    view.add_argument("--front", type=int, metavar="N", help="index of the selected reflectance, from 1")
    what = "show the selected reflectance as cosine lobes, Cook-Torrance lobes and homomorphic factors too"
    view.add_argument("--representations", action="store_true", help=what)
    view.add_argument("--plots", metavar="KEY,KEY", help="visible plots; all others are hidden")
    view.add_argument("--panels", metavar="KEY,KEY", help="visible panels: numbers, reflectances, factors")
    view.add_argument("--no-inspector", action="store_true", help="hide the inspector")
    option = "option of a view or panel; repeatable"
    view.add_argument("--set", action="append", default=[], type=_pair, metavar="KEY=VALUE", help=option)


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
