"""Recovery of a camera response from exposure series, by Robertson's energy over all pixels.

The energy Σ w(y_ij)·(g(y_ij) - t_i x_j)² weighs each code by one over the variance of its exposure, which is measured
from the photographs themselves. Robertson, Borman and Stevenson (2003) minimize it by turns, one free value for each
code; here g is a smooth curve (:mod:`brdf_suite.acquisition.response.channel`) and the radiances x_j are
eliminated, so that Gauss-Newton steps take both at once. OpenCV's ``CalibrateRobertson`` takes 8 bits only, and its
free values are noisy where codes are rare; docs/method/acquisition.md has the figures of both.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.response.channel import fit_channel, known_channel, time_residuals
from brdf_suite.acquisition.response.response import Response, linear_response
from brdf_suite.acquisition.response.samples import ResponseSamples
from brdf_suite.arrays import Floats, Integers
from brdf_suite.errors import AcquisitionError
from brdf_suite.progress import Progress, subrange

SMOOTHNESS = 1e-3
"""Weight of the third differences of ln g, over that of the photographs, where exposures differ by a factor of 1.65."""
LINEAR_RMS = 0.01
"""A curve nearer to a straight line than this, RMS of the logarithm, is taken as the line."""
CONTRADICTION = 0.2
"""A known curve under which a time of exposure seems off by more, in its logarithm, is not that of the photographs."""
_FEWEST = 300
_USUAL_GAP = 0.5
_SMOOTHEST = 0.3


@dataclass(frozen=True, eq=False)
class ResponseFit:
    """A recovered response and how well it explains the photographs.

    Attributes
    ----------
    response
        What was recovered.
    linear_rms
        (channels,) RMS distance of the curve from a straight line, in the logarithm of the exposure.
    time_residuals
        (n,) logarithm of the exposure time that the photographs show, over the one stated; the median is 0.
    pixels
        (channels,) how many pixels took part.
    iterations
        Gauss-Newton steps of the slowest channel.
    """

    response: Response
    linear_rms: Floats
    time_residuals: Floats
    pixels: Integers
    iterations: int


def calibrate_response(
    samples: ResponseSamples,
    black: npt.ArrayLike | None = None,
    *,
    linear: bool = False,
    known: Response | None = None,
    smoothness: float | None = None,
    progress: Progress | None = None,
) -> ResponseFit:
    """Return the response that explains the photographs.

    Parameters
    ----------
    samples
        Pixels of some positions, spread over the arc so that all codes are seen.
    black
        (channels,) codes without light, from dark frames; ``None``: from the darkest pixels.
    linear
        The camera is known to be linear: only the noise is measured.
    known
        A curve that is known already, such as sRGB's: only the noise is measured.
    smoothness
        Weight of the third differences of ln g, relative to that of the photographs; ``None``: as the gaps between the
        times of exposure ask.

    Raises
    ------
    AcquisitionError
        Too few pixels have two usable exposures; or photographs contradict the curve that is taken as known.
    """
    dark = samples.black() if black is None else np.broadcast_to(np.asarray(black, float), samples.channels)
    if known is None and linear:
        known = linear_response(samples.bit_depth, samples.channels, dark)
    if known is not None:
        _refuse_contradiction(samples, known)
    highest = samples.highest()
    smoothness = needed_smoothness(samples.times) if smoothness is None else smoothness
    found = []
    for c in range(samples.channels):
        codes = samples.codes(c)
        if len(codes) < _FEWEST:
            few = f"Channel {c} has only {len(codes)} pixels with two exposures that are neither black nor clipped"
            raise AcquisitionError(f"{few}; the response of the camera cannot be recovered from them.")
        place = (float(dark[c]), int(highest[c]))
        if known is not None:
            found.append(known_channel(codes, samples, *place, known.exposure[c]))
        else:
            step = subrange(progress, c / samples.channels, (c + 1) / samples.channels)
            found.append(fit_channel(codes, samples, *place, smoothness, step))
    straight = all(each.linear_rms <= LINEAR_RMS for each in found) if known is None else known.linear
    if straight and known is None:
        line = linear_response(samples.bit_depth, samples.channels, dark).exposure
        ends = zip(dark.tolist(), highest.tolist(), line, strict=True)
        found = [known_channel(samples.codes(c), samples, *end) for c, end in enumerate(ends)]
    curves, low = np.stack([each.curve for each in found]), np.array([each.low for each in found])
    read, shot = np.array([(each.read, each.shot) for each in found]).T
    response = Response(samples.bit_depth, curves, dark, low, highest, read, shot, straight)
    return ResponseFit(
        response,
        np.array([each.linear_rms for each in found]),
        time_residuals(samples, response),
        np.array([len(samples.codes(c)) for c in range(samples.channels)]),
        max(each.steps for each in found),
    )


def needed_smoothness(times: Floats) -> float:
    """Return the smoothness for a series of times.

    What exposures of a common ratio cannot determine are ripples of ln g whose period is the logarithm of that ratio.
    The wider it is, the less rough is a ripple, and the more smoothness it takes to rule it out; three exposures with a
    factor of 7 between them give the curve to 0.4 % so, and to 10 % with the smoothness that suits sixteen.
    """
    gap = float(np.max(np.diff(np.log(times))))
    return min(_SMOOTHEST, SMOOTHNESS * max(1.0, (gap / _USUAL_GAP) ** 3))


def _refuse_contradiction(samples: ResponseSamples, known: Response) -> None:
    """Raise AcquisitionError where exposures under the known curve do not grow as their times do."""
    apart = float(np.abs(time_residuals(samples, known)).max())
    if apart > CONTRADICTION:
        kind = "linear" if known.linear else "of the stated curve"
        raise AcquisitionError(
            f"The photographs are not {kind}: their pixels show times of exposure that differ from the stated ones by"
            f" up to a factor of {np.exp(apart):.3g}. Let the response be recovered (unknown), or check the times."
        )
