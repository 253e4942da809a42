"""Desktop integration on Linux: menu entries, kinds of documents with magic, icons, thumbnails, and AppStream metadata.

    python packaging/frozen/desktop.py FOLDER

writes them as they lie below ``/usr``: ``FOLDER/share/applications`` and so on.
"""

from __future__ import annotations

import re
import sys
from dataclasses import dataclass
from pathlib import Path
from xml.sax.saxutils import escape

from PySide6.QtGui import QGuiApplication

CHECKOUT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(CHECKOUT / "packaging" / "generators"))

from icons import ICONS, rendered  # noqa: E402 - a script beside, not a package

from brdf_suite.release import __version__  # noqa: E402

CHANGES = (CHECKOUT / "CHANGELOG.md").read_text(encoding="utf-8")
"""Its first heading is the release with its date."""
SIDES = (16, 24, 32, 48, 64, 128, 256)
IDENTITY = "org.brdf_suite.BrdfSuite"


@dataclass(frozen=True)
class Entry:
    """A program in the menu: names and remarks by language, and the endings of what it opens."""

    command: str
    name: str
    comment: str
    comment_de: str
    endings: tuple[str, ...]


PROGRAMS = (
    Entry(
        "brdf-designer",
        "BRDF Suite Designer",
        "Design the appearance of automotive paint",
        "Das Aussehen von Autolack gestalten",
        ("brdfpaint",),
    ),
    Entry(
        "brdf-viewer",
        "BRDF Suite Viewer",
        "See paints on a car in a real environment",
        "Lacke auf einem Auto in einer echten Umgebung sehen",
        ("brdfview", "brdfstudio", "brdfproject", "brdfpaint"),
    ),
    Entry(
        "brdf-lobes",
        "BRDF Suite Lobe Visualizer",
        "Look at reflectances in three dimensions",
        "Reflexionen in drei Dimensionen ansehen",
        ("brdfpaint", "brdfproject"),
    ),
    Entry(
        "brdf-swatch",
        "BRDF Suite Color Swatch",
        "Organize paints as palettes",
        "Lacke in Paletten ordnen",
        ("brdfpalette", "brdfproject"),
    ),
)
DOCUMENTS = {
    "brdfpaint": ("BRDF Suite paint", "BRDF-Suite-Lack"),
    "brdfpalette": ("BRDF Suite palette", "BRDF-Suite-Palette"),
    "brdfview": ("BRDF Suite view", "BRDF-Suite-Ansicht"),
    "brdfstudio": ("BRDF Suite studio", "BRDF-Suite-Studio"),
    "brdfproject": ("BRDF Suite project", "BRDF-Suite-Projekt"),
}
"""The kinds of documents by their endings, in English and German."""
THUMBNAILS = ("brdfpaint", "brdfpalette")


def mime(ending: str) -> str:
    """Return the media type of a kind of document."""
    return f"application/x-{ending}"


def menu_entry(entry: Entry) -> str:
    """Return the ``.desktop`` file of a program."""
    return (
        "[Desktop Entry]\nType=Application\nVersion=1.4\n"
        f"Name={entry.name}\nComment={entry.comment}\nComment[de]={entry.comment_de}\n"
        f"Exec={entry.command} --open %F\nTryExec={entry.command}\nIcon={entry.command}\nTerminal=false\n"
        "Categories=Graphics;3DGraphics;\nKeywords=paint;colour;color;BRDF;automotive;\n"
        f"MimeType={''.join(mime(ending) + ';' for ending in entry.endings)}\n"
        f"StartupWMClass={entry.name.removeprefix('BRDF Suite ')}\nStartupNotify=true\n"
        "Actions=new;\n\n[Desktop Action new]\nName=New Window\nName[de]=Neues Fenster\n"
        f"Exec={entry.command}\n"
    )


def suite_entry() -> str:
    """Return the ``.desktop`` file of the whole suite, of which an AppImage has one."""
    types = "".join(mime(ending) + ";" for ending in DOCUMENTS)
    return (
        "[Desktop Entry]\nType=Application\nVersion=1.4\nName=BRDF Suite\n"
        f"Comment={PROGRAMS[0].comment}\nComment[de]={PROGRAMS[0].comment_de}\nExec=brdf-suite %F\nIcon=brdf-suite\n"
        f"Terminal=false\nCategories=Graphics;3DGraphics;\nMimeType={types}\n"
    )


def media_types() -> str:
    """Return the description of the kinds of documents, by ending and by content."""
    kinds = []
    for ending, (english, german) in DOCUMENTS.items():
        if ending == "brdfproject":
            # A zip file whose first part is the list of its contents.
            magic = (
                '<match type="string" offset="0" value="PK\\003\\004">'
                '<match type="string" offset="30" value="project.json"/></match>'
            )
            parent = '<sub-class-of type="application/zip"/>'
        else:
            magic = f'<match type="string" offset="0:64" value="&quot;format&quot;: &quot;{ending}&quot;"/>'
            parent = '<sub-class-of type="application/json"/>'
        kinds.append(
            f'  <mime-type type="{mime(ending)}">\n    <comment>{escape(english)}</comment>\n'
            f'    <comment xml:lang="de">{escape(german)}</comment>\n    {parent}\n    <icon name="{ending}"/>\n'
            f'    <magic priority="60">{magic}</magic>\n    <glob pattern="*.{ending}"/>\n  </mime-type>\n'
        )
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<mime-info xmlns="http://www.freedesktop.org/standards/shared-mime-info">\n{"".join(kinds)}</mime-info>\n'
    )


def thumbnailer() -> str:
    """Return what has file managers draw small pictures."""
    types = "".join(mime(ending) + ";" for ending in THUMBNAILS)
    words = "brdf-suite thumbnail %i -o %o --size %s --quiet"
    return f"[Thumbnailer Entry]\nTryExec=brdf-suite\nExec={words}\nMimeType={types}\n"


def metadata() -> str:
    """Return the AppStream description."""
    released = re.search(rf"^## {re.escape(__version__)} – (\S+)$", CHANGES, re.MULTILINE)
    date = f' date="{released[1]}"' if released else ""
    provided = "".join(f"<mediatype>{mime(ending)}</mediatype>" for ending in DOCUMENTS)
    commands = "".join(f"<binary>{entry.command}</binary>" for entry in PROGRAMS)
    launched = "".join(
        f'  <launchable type="desktop-id">{entry.command}.desktop</launchable>\n' for entry in PROGRAMS
    )
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<component type="desktop-application">
  <id>{IDENTITY}</id>
  <metadata_license>CC0-1.0</metadata_license>
  <project_license>Apache-2.0 AND BSD-3-Clause AND MIT</project_license>
  <name>BRDF Suite</name>
  <summary>Design automotive paint and see it on a car</summary>
  <summary xml:lang="de">Autolack gestalten und auf einem Auto sehen</summary>
  <developer id="org.brdf_suite"><name>The BRDF Suite authors</name></developer>
  <description>
    <p>Design a metallic or pearl paint by its colours at several angles, its gloss and its flakes, and see it at once
    on a car in a real environment.</p>
    <p>Measured reflectances are fitted and drawn in three dimensions. Palettes of paints are kept, searched and
    exchanged with other programs.</p>
  </description>
  <icon type="stock">brdf-suite</icon>
{launched}  <provides>{commands}<binary>brdf-suite</binary>{provided}</provides>
  <categories><category>Graphics</category><category>3DGraphics</category></categories>
  <content_rating type="oars-1.1"/>
  <releases><release version="{__version__}"{date}/></releases>
</component>
"""


def write(prefix: Path) -> list[Path]:
    """Write all files below ``prefix``, which stands for ``/usr``; return them."""
    app = QGuiApplication.instance() or QGuiApplication(["desktop", "-platform", "offscreen"])
    share = prefix / "share"
    texts = {
        **{share / "applications" / f"{entry.command}.desktop": menu_entry(entry) for entry in PROGRAMS},
        share / "mime" / "packages" / "brdf-suite.xml": media_types(),
        share / "thumbnailers" / "brdf-suite.thumbnailer": thumbnailer(),
        share / "metainfo" / f"{IDENTITY}.metainfo.xml": metadata(),
    }
    for path, text in texts.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    written = [*texts]
    for name, svg in ICONS.items():
        folder = "apps" if name.startswith("brdf-") else "mimetypes"
        for side in SIDES:
            path = share / "icons" / "hicolor" / f"{side}x{side}" / folder / f"{name}.png"
            path.parent.mkdir(parents=True, exist_ok=True)
            rendered(svg, side).save(str(path))
            written.append(path)
        path = share / "icons" / "hicolor" / "scalable" / folder / f"{name}.svg"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(svg, encoding="utf-8")
        written.append(path)
    del app
    return written


if __name__ == "__main__":
    print(f"{len(write(Path(sys.argv[1])))} files written")
