"""Photographs of a painted sphere: a table of its reflectance from them, and simulated ones."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from brdf_suite.errors import PathLike
from brdf_suite.library.subjects import Subject, material_for
from brdf_suite.progress import Progress

if TYPE_CHECKING:
    from brdf_suite.acquisition.reconstruction.table import Acquired


def acquire(
    folder: PathLike,
    path: PathLike,
    *,
    linear: bool = False,
    refine: bool = True,
    grazing_deg: float = 80.0,
    overwrite: bool = False,
    restart: bool = False,
    progress: Progress | None = None,
) -> Acquired:
    """Reconstruct a table of half-angle bins from photographs of a painted sphere (Günther et al. 2005), and write it.

    It needs the extra ``acquisition``. What is done is kept beside ``path`` until the table is whole: stopped, the same
    call resumes where it was.

    Parameters
    ----------
    folder
        Of a session: ``session.json`` and the photographs; :func:`simulate` makes one.
    path
        The ``.brdftable`` (with coverage) or ``.binary`` (MERL) to write.
    linear
        Whether the camera is linear, so that no response is recovered.
    refine
        Whether highlights may correct the stated geometry.
    grazing_deg
        30 to less than 90: readings whose light or view is further from the normal are left out.
    overwrite
        Whether a file that is there is replaced.
    restart
        Whether what an earlier call left is forgotten.
    progress
        Called with a share, 0 to 1, and a sentence; it may raise ``brdf_suite.errors.Cancelled``.

    Returns
    -------
    Acquired
        ``table`` is the reflectance, which every function takes; ``readings`` how many there were; ``notices``.

    Raises
    ------
    SuiteError
        The folder or a photograph is not as wanted, or the table cannot be written.
    MissingExtraError
        The extra is not installed; the message says how to install it.

    >>> import brdf_suite as bs
    >>> bs.acquire("no such folder", "sphere.brdftable")
    Traceback (most recent call last):
    brdf_suite.errors.FileError: no such folder...
    """
    from brdf_suite.acquisition.reconstruction.options import AcquireOptions
    from brdf_suite.acquisition.reconstruction.output import acquire as acquire_session
    from brdf_suite.acquisition.reconstruction.reconstruction import Acquisition

    options = AcquireOptions(grazing_deg=grazing_deg, refine=refine, response="linear" if linear else "auto")
    return acquire_session(
        Acquisition.open(Path(folder), options), Path(path), progress, overwrite=overwrite, restart=restart
    )


def simulate(
    subject: Subject,
    folder: PathLike,
    *,
    size: tuple[int, int] = (320, 320),
    positions: int = 180,
    exposures: int = 16,
    bits: int = 12,
    noise: bool = True,
    seed: int = 0,
    progress: Progress | None = None,
) -> Path:
    """Photograph a sphere of a subject in a simulated rig: a session's folder, which :func:`acquire` takes.

    It needs the extra ``acquisition``.

    Parameters
    ----------
    subject
        A name, a file, a paint, a material, a fit, or anything with ``eval``.
    folder
        New or empty; ``truth.json`` in it says what is true.
    size
        (width, height) of the photographs in pixels, each 16 to 16,384.
    positions
        Of the lamp, even over 180°.
    exposures
        At each position, a geometric series of 0.25 to 328 ms.
    bits
        8 to 16, of the camera's codes.
    noise
        Whether the camera has noise and dark current.
    seed
        Of the noise.

    Raises
    ------
    SuiteError
        As :func:`load`; a number is out of its range, or the folder holds something.
    MissingExtraError
        The extra is not installed; the message says how to install it.

    >>> import brdf_suite as bs, tempfile, pathlib
    >>> folder = pathlib.Path(tempfile.mkdtemp()) / "session"
    >>> found = bs.simulate("table1_white", folder, size=(32, 32), positions=2, exposures=2)
    >>> (found / "session.json").is_file()
    True
    """
    from brdf_suite.acquisition.simulator import SimulatorSettings
    from brdf_suite.acquisition.simulator import simulate as simulate_session

    settings = SimulatorSettings(
        size=size, positions=positions, exposures=exposures, bit_depth=bits, noise=noise, seed=seed
    )
    material = material_for(subject)
    simulate_session(material.reflectance, folder, settings, material.name, progress)
    return Path(folder)
