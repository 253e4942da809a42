"""The mask of a session as a picture beside its photographs: white is used, black left out."""

from __future__ import annotations

import io
from dataclasses import replace
from pathlib import Path

import numpy as np
from PIL import Image

from brdf_suite.acquisition.session.session import Session
from brdf_suite.acquisition.session.store import read_session, write_session
from brdf_suite.arrays import Bools
from brdf_suite.documents.atomic import write_atomically

MASK_FILE = "mask.png"
_MOST_NAMES = 100


def write_session_mask(folder: Path, session: Session, used: Bools) -> Session:
    """Write the mask into the folder and name it in session.json; return the session that names it.

    A mask of another name is left as it is, and so is a ``mask.png`` beside it that the session does not use.

    Raises
    ------
    FileError
        The folder cannot be written.
    """
    name = session.mask or MASK_FILE
    if name != MASK_FILE and not (name.startswith("mask_") and name.endswith(".png")):
        names = [MASK_FILE, *(f"mask_{number}.png" for number in range(2, _MOST_NAMES))]
        name = next((free for free in names if not (folder / free).exists()), MASK_FILE)
    stream = io.BytesIO()
    Image.fromarray(np.where(used, 255, 0).astype(np.uint8)).save(stream, "png", optimize=True)
    write_atomically(folder / name, stream.getvalue())
    # Changes that other programs made meanwhile are kept: only the mask's name is changed.
    present = read_session(folder)
    if present.mask != name:
        present = replace(present, mask=name)
        write_session(present, folder)
    return present
