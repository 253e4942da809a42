"""Hook of MkDocs: the pages in the order of docs/README.md, which Help ▸ Manual shows too."""

from __future__ import annotations

import re
from html import escape
from pathlib import Path
from typing import Any

from brdf_suite.library.reference import list_pages

_PIPE_IN_CODE = re.compile(r"`([^`\n]*\\\|[^`\n]*)`")


def on_config(config: Any) -> Any:
    """Set the navigation."""
    root = Path(config.docs_dir)
    chapters = list_pages(root).items()
    config.nav = [
        {"Contents": "README.md"},
        *(
            {chapter: [{title: page.relative_to(root).as_posix()} for title, _, page in pages]}
            for chapter, pages in chapters
        ),
    ]
    return config


def on_page_markdown(markdown: str, **_: Any) -> str:
    """Return the page with pipes in the code of tables as this Markdown wants them; others want a backslash."""
    return _PIPE_IN_CODE.sub(
        lambda match: f"<code>{escape(match[1]).replace(chr(92) + '|', '&#124;')}</code>", markdown
    )
