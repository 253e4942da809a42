"""Metadata of the built package that depend on where the project is published: addresses, and the description.

A hook of the build (``[tool.hatch.metadata.hooks.custom]`` in pyproject.toml). On a package index a relative link leads
nowhere; so the README's links and pictures get absolute addresses, or are left out where there is no address.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from hatchling.metadata.plugin.interface import MetadataHookInterface

_LINK = re.compile(r"(!?)\[([^\]]*)\]\((?!https?:|mailto:)([^)\s]+)\)")
_MARK = re.compile(r"<!--.*?-->", re.DOTALL)


def description(text: str, address: str, version: str) -> str:
    """Return a page for a place where the files beside it are not.

    >>> description("![a car](docs/car.png) [use](docs/use.md)", "", "1.0")
    ' use'
    >>> description("[use](docs/use.md#one)", "https://host/owner/name", "1.0")
    '[use](https://host/owner/name/blob/v1.0/docs/use.md#one)'
    """

    def absolute(link: re.Match[str]) -> str:
        mark, words, target = link.groups()
        if not address:
            return "" if mark else words
        if target.startswith("#"):
            target = f"README.md{target}"
        return f"{mark}[{words}]({address}/{'raw' if mark else 'blob'}/v{version}/{target})"

    found = _LINK.sub(absolute, _MARK.sub("", text))
    return re.sub(r"\n{3,}", "\n\n", found)


def addresses(address: str) -> dict[str, str]:
    """Return the project's addresses by what they lead to; none of no address."""
    if not address:
        return {}
    return {
        "Homepage": address,
        "Documentation": f"{address}/blob/main/docs/README.md",
        "Changelog": f"{address}/blob/main/CHANGELOG.md",
        "Source": address,
        "Issues": f"{address}/issues",
    }


class ProjectMetadata(MetadataHookInterface):
    """Fills in the description and the addresses, from ``address`` in the hook's settings."""

    def update(self, metadata: dict[str, Any]) -> None:
        """Change the metadata in place."""
        address = str(self.config["address"]).rstrip("/")
        text = (Path(self.root) / "README.md").read_text(encoding="utf-8")
        page = description(text, address, metadata["version"])
        metadata["readme"] = {"content-type": "text/markdown", "text": page}
        metadata["urls"] = addresses(address)
