"""Write THIRD_PARTY.md: what the suite is installed with and what is in it by others, and under which licences.

``.venv/bin/python packaging/third_party.py``, from what is installed here. Versions are in the bill of materials
(``packaging/sbom.py``).
"""

from __future__ import annotations

from pathlib import Path

from runtime_packages import PROJECT, Package, runtime_packages

ROOT = Path(__file__).resolve().parent.parent
FILE = ROOT / "THIRD_PARTY.md"

_HEAD = """\
# Work of others

BRDF Suite is under the Apache License 2.0. The packages below are not in its own: an installer fetches them, each under
its own licence. `packaging/third_party.py` makes this page from their metadata.

## In the package

| what | by | licence |
|---|---|---|
| icons, `resources/icons` | Phosphor Icons 1.3.0 | MIT, `resources/icons/LICENSE` |
| the sky, `resources/sky` | L. Hošek, A. Wilkie | BSD-3-Clause, `resources/sky/LICENSE_hosek_wilkie.txt` |

"""


def page() -> str:
    """Return the whole page."""
    found = [one for name, one in runtime_packages().items() if name != PROJECT]
    always = [one for one in found if not one.extra]
    optional = [one for one in found if one.extra]
    return (
        f"{_HEAD}## Installed with it\n\n{_table(always)}\n"
        f"## Installed with its extras\n\n{_table(optional, extras=True)}"
    )


def _table(packages: list[Package], *, extras: bool = False) -> str:
    head = ["package", *(["extra"] if extras else []), "licence", "address"]
    rows = [head, ["---"] * len(head)]
    for one in packages:
        extra = [one.extra] if extras else []
        rows.append([one.name, *extra, one.licence or "not stated", one.address])
    return "".join(f"|{'|'.join(f' {cell} ' for cell in row)}|\n" for row in rows).replace(" --- ", "---")


if __name__ == "__main__":
    FILE.write_text(page(), encoding="utf-8")
