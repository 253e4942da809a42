"""Write one small document of every kind with the code of an earlier release: tests read them with today's.

    python packaging/generators/old_documents.py CHECKOUT FOLDER

``CHECKOUT`` holds that release's source, whose code alone writes; ``tests/documents/old/0.1.0`` was made from commit
475cc216, the last of version 0.1.0. The values below are made by the same lines in a test, with today's classes, and
compared with what is read. A release whose formats changed gets a folder of its own.
"""

from __future__ import annotations

import shutil
import sys
from dataclasses import replace
from pathlib import Path

if __name__ == "__main__":
    sys.path[:0] = [sys.argv[1], str(Path(sys.argv[1], "apps"))]  # before the installed suite

import numpy as np

import brdf_suite
from brdf_suite.acquisition.session.session import (
    Board,
    FlatField,
    Lens,
    Light,
    Position,
    Session,
    SessionCamera,
    Sphere,
    WhiteReference,
)
from brdf_suite.acquisition.session.store import write_session
from brdf_suite.arrays import AnyArray
from brdf_suite.documents.cook_torrance import Clearcoat, CookTorranceLobe, CookTorrancePaint
from brdf_suite.documents.factor_textures import write_textures
from brdf_suite.documents.factored import FactoredPaint, TextureFile
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Flakes, Gloss, Measurement, OrangePeel, Paint, TextureTargets
from brdf_suite.documents.palette import Entry, Group, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.project import NamedView, Project, ProjectPicture, save_project
from brdf_suite.documents.store import save_paint, save_view
from brdf_suite.documents.studio import Backdrop, BoothRoom, Sky, Studio, StudioLamp, save_light
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import (
    Compare,
    Lamp,
    LightColour,
    PartMaterial,
    Relief,
    Sparkle,
    SurfaceLook,
    TwoTone,
)
from brdf_suite.documents.view_settings import Lens as ViewLens
from brdf_suite.files.measured.brdftable import write_brdftable
from brdf_suite.fitting.basis_search.document import save_basis
from brdf_suite.fitting.basis_search.search import CountResult
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.factored.map import MapFactor
from brdf_suite.reflectance.factored.model import Factored
from brdf_suite.reflectance.tabulated.anisotropic import AnisotropicTable
from brdf_suite.reflectance.tabulated.isotropic import Coverage, IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

FACTS = {"format": "MERL", "notes": ("one", "zwei ü"), "holes": 3, "scaled": True, "albedo": 0.25}
MAPS = {
    "p": np.linspace(0.1, 1.0, 12, dtype=np.float32).reshape(2, 2, 3),
    "q": np.linspace(0.2, 2.0, 12, dtype=np.float32).reshape(2, 2, 3),
}
"""The maps of the factored paint."""
EXPONENTS = (2.0, 20.0, 200.0)


def aspecular() -> Paint:
    """Return a paint by its readings, with every part."""
    lab = {15.0: (62.0, -4.0, -45.0), 45.0: (25.5, 4.0, -38.0), 110.0: (9.0, 8.25, -28.0)}
    return Paint(
        "Meer",
        tuple(Measurement(45.0, angle, value) for angle, value in lab.items()),
        Gloss(90.0, 94.0),
        Flakes(2500.0, 18.0, 0.2, 0.1),
        near_specular=1.2,
        notes="zwei\nZeilen",
        source="a colourist",
        orange_peel=OrangePeel(0.6, 5.0),
        scattering="single",
        texture=TextureTargets(grade_15=4.0, graininess=0.05),
    )


def cook_torrance() -> CookTorrancePaint:
    """Return a paint by lobes."""
    lobes = (CookTorranceLobe((0.1, 0.2, 0.3), 0.25, 0.1), CookTorranceLobe((0.5, 0.5, 0.4), 0.05, 0.6))
    return CookTorrancePaint(
        "Lobes", (0.2, 0.1, 0.05), lobes, "quarter", Clearcoat(1.45, 0.01, "single"), Flakes(), "n", "s"
    )


def factored(textures: TextureFile) -> FactoredPaint:
    """Return a paint by :data:`MAPS`, which are in a file."""
    return FactoredPaint(
        "Maps", textures, "p:wo q:h p:wi", (0.5, 1.0, 2.0), largest=12.0, clearcoat=Clearcoat()
    )


def palette() -> Palette:
    """Return a palette of both kinds of paints and of flat colours in two models."""
    entries = (
        Entry(aspecular(), "a", ("Blue", "Dark"), "B-12", ("metallic", "new"), "noted", date="2026-11-20"),
        Entry(cook_torrance(), "b", ("Blue",)),
        Entry(FlatColour("Ink", "CMYK", (1.0, 0.5, 0.0, 0.1), "FOGRA39"), "c", usage="spot"),
        Entry(FlatColour("", "Lab", (50.0, 10.0, -20.0), illuminant="D50", observer_deg=2), "d"),
    )
    groups = (Group(("Blue",), "of the sea", "#0000ff"), Group(("Blue", "Dark")), Group(("Empty",)))
    return Palette("Summer", entries, groups, "notes", "#102030", 4)


def view() -> View:
    """Return a view that has no default where it can have another value."""
    return View(
        Camera(20.0, 10.0, 3.0, (0.1, 0.2, 0.3), 85.0),
        "booth",
        "car",
        30.0,
        1.5,
        "aces",
        "colour",
        "multi_angle",
        "auto",
        "paper",
        "automatic",
        (0.1, 0.2, 0.3),
        True,
        True,
        "colour",
        LightColour("D50", False, 0.5),
        (Lamp("point", (1.0, 2.0, 3.0), strength=2.0, diameter=0.1), Lamp("directional", angle_deg=0.5)),
        Sparkle("texture", 4, 2.0),
        SurfaceLook("mm", 2.0, True, True, "smooth", (PartMaterial("body", "paint"),), False, True, "z"),
        Relief("/maps/normal.png", 2.0, 50.0, 0.3, 5.0),
        TwoTone("copper", "/maps/mask.png", 500.0, "side"),
        Compare("swipe", "red", 0.4, 2.0, 8.0, "picture"),
        -12.0,
        "ball",
        "eye",
        ViewLens(4.0, 2.5, 10.0),
    )


def lights() -> dict[str, Studio | Sky]:
    """Return a studio in a room, one before a backdrop, and a sky."""
    lamps = (
        StudioLamp("box", (1.0, 2.0, 0.5), (1.0, 0.5), (0.0, -1.0, 0.0), 15.0, 8.0, 5000.0),
        StudioLamp("strip", (-1.0, 2.0, 0.5), (2.0, 0.2)),
        StudioLamp("ring", (0.0, 1.0, 2.0), (0.8, 0.2), softness_m=0.02),
    )
    return {
        "room": Studio("Room", lamps, BoothRoom(8.0, 12.0, 4.0, 1.0, 0.3, 0.4, 0.5), unit="relative"),
        "backdrop": Studio("Backdrop", lamps, backdrop=Backdrop(0.2, 6000.0)),
        "sky": Sky("Sky", "preetham", 3.0, 30.0, 120.0, 0.3, False),
    }


def project(source: Path) -> Project:
    """Return a project of everything that one holds, designed from the measured file ``source``."""
    return Project(
        "Launch",
        (aspecular(), cook_torrance()),
        cook_torrance(),
        (NamedView("front", replace(view(), relief=Relief(), two_tone=TwoTone())),),
        tuple(lights().values()),
        str(source),
        (ProjectPicture("large", "front", 640, 480, 2),),
        "notes",
    )


def session() -> Session:
    """Return a session of photographs that uses every field."""
    camera = SessionCamera(
        1.5,
        0.1,
        14,
        "linear",
        -2.0,
        ((0.8, 0.1, 0.1), (0.1, 0.8, 0.1), (0.0, 0.2, 0.8)),
        Lens(2000.0, 2001.0, 512.0, 384.0, 0.01, -0.02, 0.001, 0.002, 0.003),
        Board(9, 6, 0.025, ("board1.png", "board2.png")),
    )
    return Session(
        name="Ball",
        camera=camera,
        sphere=Sphere(0.05, (0.001, 0.0, -0.002)),
        light=Light(1.2, 0.2, (10.0, 11.0, 12.0), ((0.0, 1.0), (10.0, 0.9)), 0.5, 0.04, 0.01),
        exposures_s=(0.01, 0.1),
        positions=(Position(10.0, ("a1.png", "a2.png"), "mask_a.png"), Position(20.0, ("b1.png", "b2.png"))),
        white=WhiteReference(("w1.png", "w2.png"), (10, 20, 30, 40)),
        dark=("d1.png", "d2.png"),
        flat_field=FlatField(("f1.png",), (0.05,)),
        mask="mask.png",
        notes="noted",
        date="2026-11-20",
    )


def tables() -> dict[str, IsotropicTable | AnisotropicTable | Factored | ScatteredSamples]:
    """Return a table of every kind."""

    def even(*shape: int) -> AnyArray:
        return np.linspace(0.1, 0.9, int(np.prod(shape)), dtype=np.float32).reshape(shape)

    holes = np.arange(4 * 5 * 6).reshape(4, 5, 6) % 3 == 0
    coverage = Coverage(np.where(holes, 0.0, 3.0).astype(np.float32), np.zeros_like(holes, np.float32))
    wi, wo = spherical(np.linspace(0.0, 1.4, 8), 0.5), spherical(np.linspace(0.1, 1.2, 8), 0.0)
    peak = (MapFactor("sqrt|h|", even(12, 3), True, "s"), MapFactor("w.h", even(4, 3), True, "f"))
    more = (MapFactor("h", even(5, 5, 3), False, "g"),)
    alpha = (0.5, 1.0, 2.0)
    return {
        "isotropic": IsotropicTable(even(4, 5, 6, 3), holes, True, "a sphere", FACTS, coverage=coverage),
        "anisotropic": AnisotropicTable(
            even(3, 4, 2, 4, 3).astype(np.float64),
            np.array([0.0, 0.5, 1.0]),
            np.array([0.2, 1.4]),
            "brushed",
            FACTS,
        ),
        "factored": Factored(even(4, 4, 3), even(6, 6, 3), alpha, "a product", FACTS),
        "product": Factored(
            even(6, 3), even(8, 3), alpha, "a product", FACTS, more=more, peak=peak, logarithmic=True
        ),
        "scattered": ScatteredSamples(
            wi,
            wo,
            even(8, 3).astype(np.float64),
            even(8, 4).astype(np.float64),
            np.linspace(400.0, 700.0, 4),
            isotropic=False,
            source="x",
            facts=FACTS,
        ),
    }


def write(folder: Path) -> None:
    """Write all documents into a folder, which is made."""
    folder.mkdir(parents=True)
    save_paint(aspecular(), folder / "aspecular.brdfpaint")
    save_paint(cook_torrance(), folder / "cook_torrance.brdfpaint")
    textures = write_textures(MAPS, folder / "factored.brdfpaint")
    save_paint(factored(textures), folder / "factored.brdfpaint")
    save_palette(palette(), folder / "palette.brdfpalette")
    save_view(view(), folder / "view.brdfview")
    for name, light in lights().items():
        save_light(light, folder / f"{name}.brdfstudio")
    for name, table in tables().items():
        write_brdftable(table, folder / f"{name}.brdftable")
    write_session(session(), folder)
    save_project(project(folder / "isotropic.brdftable"), folder / "project.brdfproject", collect=True)
    result = CountResult(EXPONENTS, (1.0,), (0.5,), (0.5,), 10, 1.0, ())
    save_basis(folder / "basis.json", ("Meer",), [result], 3, {"made": "for a test"})


def write_settings(folder: Path) -> None:
    """Write what Viewer keeps of :func:`view`, and a format of Designer's export."""
    from brdf_viewer.documents.remembered import remember  # Qt, which the documents do without
    from PySide6.QtCore import QSettings

    folder.mkdir()
    store = QSettings(str(folder / "Viewer.ini"), QSettings.Format.IniFormat)
    remember(store, view())
    store.sync()
    store = QSettings(str(folder / "Designer.ini"), QSettings.Format.IniFormat)
    store.setValue("handover/format", "csv")
    store.sync()


if __name__ == "__main__":
    checkout, out = (Path(word).resolve() for word in sys.argv[1:3])
    if checkout not in Path(brdf_suite.__file__).parents:
        sys.exit(f"{brdf_suite.__file__} is not the code of {checkout}")
    shutil.rmtree(out, ignore_errors=True)
    write(out)
    write_settings(out / "settings")
    print(*sorted(path.name for path in out.iterdir()), sep="\n")
