"""Text escaping for XML."""

from __future__ import annotations

import re
from xml.sax.saxutils import escape, quoteattr

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.hardened_xml import Element, parse_xml

_NO_XML = re.compile("[^\t\n -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def attribute(text: str) -> str:
    """Return a text as the value of an attribute, with its quotes; characters that XML does not know become U+FFFD."""
    return quoteattr(_NO_XML.sub("\ufffd", text), {"\n": "&#10;", "\t": "&#9;"})


def text_content(text: str) -> str:
    """Return a text as the content of an element."""
    return escape(_NO_XML.sub("\ufffd", text))


def read_root(data: bytes, path: PathLike, *names: str) -> Element:
    """Return the root of an XML file, which must have one of these local names.

    Raises
    ------
    FileError
        It is damaged, hostile (a document type, too deep), or something else; with the line.
    """
    root = parse_xml(data, path)
    if root.name not in names:
        raise FileError(path, f"its root is {root.name[:60]!r}, not {names[0]!r}", f"line {root.line}")
    return root


def mentions(head: bytes, *words: str) -> bool:
    """Return whether one of these words stands at the beginning of an XML file, in UTF-8 or UTF-16."""
    if not head.lstrip(b"\xef\xbb\xbf \t\r\n").startswith((b"<", b"\xff\xfe<", b"\xfe\xff\0<")):
        return False
    return any(word.encode(code) in head for word in words for code in ("utf-8", "utf-16-le", "utf-16-be"))
