"""Collect the texts of the windows, and those of the core that they show, and make the translations.

    python packaging/translate.py            # collect into packaging/translations/*.ts, release into resources/
    python packaging/translate.py --check    # say what is not translated, or not collected; write nothing

Beside the translations lie the templates of the core's texts, by which the windows find a finished text again.

The ``.ts`` files are edited by hand or with Qt Linguist (``pyside6-linguist packaging/translations/de.ts``).
"""

from __future__ import annotations

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from xml.etree import ElementTree

sys.path.insert(0, str(Path(__file__).resolve().parent))

from core_texts import core_texts

ROOT = Path(__file__).resolve().parent.parent
SOURCES = ROOT / "packaging" / "translations"
RELEASED = ROOT / "resources" / "translations"
CORE = ROOT / "brdf_suite"
TEMPLATES = RELEASED / "core_templates.json"
PROGRAMS = ("brdf_qt", "brdf_designer", "brdf_lobe_visualizer", "brdf_color_swatch", "brdf_viewer")
_PLACE = re.compile(r"\{[^}]*\}")


def collect(target: Path) -> None:
    """Bring the ``.ts`` file ``target`` up to what the sources of the programs and of the core say."""
    files = [
        str(path.relative_to(ROOT))
        for name in PROGRAMS
        for path in sorted((ROOT / "apps" / name).rglob("*.py"))
    ]
    options = [
        "-no-obsolete",
        "-locations",
        "none",
        "-source-language",
        "en",
        "-tr-function-alias",
        "tr+=mark",
    ]
    with tempfile.TemporaryDirectory() as folder:
        core = Path(folder) / "core.py"
        core.write_text("".join(f"tr({text!r})\n" for text in _finished_texts()), encoding="utf-8")
        _tool("pyside6-lupdate", *options, *files, str(core), "-ts", str(target))


def _finished_texts() -> list[str]:
    return core_texts(CORE, [ROOT / "apps" / name for name in PROGRAMS])


def templates() -> str:
    """Return the content of the file of templates: the core's texts that have places, as JSON."""
    found = [text for text in _finished_texts() if _PLACE.search(text)]
    return json.dumps(found, ensure_ascii=False, indent=0) + "\n"


def release(source: Path, target: Path) -> None:
    """Make the ``.qm`` file ``target`` of a ``.ts`` file."""
    _tool("pyside6-lrelease", "-silent", str(source), "-qm", str(target))


def faults(source: Path) -> list[str]:
    """Return what is wrong with a ``.ts`` file: texts without translation, places that are lost or invented."""
    found = []
    for message in ElementTree.parse(source).iter("message"):
        text = message.findtext("source") or ""
        translation = message.find("translation")
        words = "" if translation is None else (translation.text or "")
        if not words or (translation is not None and translation.get("type") == "unfinished"):
            found.append(f"not translated: {text!r}")
        elif sorted(_PLACE.findall(text)) != sorted(_PLACE.findall(words)):
            found.append(f"other places in braces: {text!r} and {words!r}")
        elif text.count("&") != words.count("&") and "&" in text.replace("&&", ""):
            found.append(f"without its access key: {text!r} and {words!r}")
        elif "amp;" in words:
            found.append(f"an access key written as text: {text!r} and {words!r}")
    return found


def main() -> int:
    """Collect and release, or check."""
    parser = argparse.ArgumentParser(description="Translations of the windows.")
    parser.add_argument(
        "--check", action="store_true", help="only say what is wrong; status 1 where anything is"
    )
    check = parser.parse_args().check
    wrong = []
    for source in sorted(SOURCES.glob("*.ts")):
        if check:
            with tempfile.TemporaryDirectory() as folder:
                fresh = Path(folder) / source.name
                shutil.copyfile(source, fresh)
                collect(fresh)
                if _texts(fresh) != _texts(source):
                    wrong.append(f"{source.name}: texts have changed since they were collected")
                wrong += [f"{source.name}: {fault}" for fault in faults(fresh)]
        else:
            collect(source)
            release(source, RELEASED / f"{source.stem}.qm")
            wrong += [f"{source.name}: {fault}" for fault in faults(source)]
    if not check:
        TEMPLATES.write_text(templates(), encoding="utf-8")
    elif TEMPLATES.read_text(encoding="utf-8") != templates():
        wrong.append(f"{TEMPLATES.name}: texts of the core have changed since they were collected")
    print("\n".join(wrong) or "Everything is translated.")
    return 1 if wrong and check else 0


def _texts(source: Path) -> set[tuple[str, str]]:
    messages = ElementTree.parse(source).iter("message")
    return {(message.findtext("source") or "", message.findtext("comment") or "") for message in messages}


def _tool(name: str, *arguments: str) -> None:
    command = [str(Path(sys.executable).with_name(name)), *arguments]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{name} failed:\n{done.stdout}{done.stderr}")


if __name__ == "__main__":
    sys.exit(main())
