"""XML reader that is safe against hostile or damaged files.

A document type is refused, and with it every way to declare an entity: nothing is expanded, fetched or nested without
end. Size, depth and number of elements are bounded. Every element knows its line, for messages.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from xml.parsers import expat
from xml.sax.saxutils import escape, quoteattr

from brdf_suite.errors import FileError, PathLike

MOST_BYTES = 64 << 20
"""A file of ten thousand samples with six spectra each has about 30 MB."""
MOST_ELEMENTS = 1_000_000
DEEPEST = 64
_SEPARATOR = "\n"  # in no name


@dataclass(eq=False)
class Element:
    """An element by its local name; ``text`` excludes its children's text."""

    name: str
    namespace: str
    attributes: dict[str, str]
    line: int
    children: list[Element] = field(default_factory=list)
    parts: list[str] = field(default_factory=list)

    @property
    def raw(self) -> str:
        """Its own text as it stands in the file."""
        return "".join(self.parts)

    @property
    def text(self) -> str:
        """Its own text, without the white space around it."""
        return self.raw.strip()

    def all(self, name: str) -> list[Element]:
        """Return the children called ``name``."""
        return [child for child in self.children if child.name == name]

    def first(self, *path: str) -> Element | None:
        """Return the first element at the end of a path of names, or None."""
        found: Element | None = self
        for name in path:
            found = next((child for child in found.children if child.name == name), None) if found else None
        return found

    def walk(self) -> Iterator[Element]:
        """Yield this element and all below it, in the order of the file."""
        waiting = [self]
        while waiting:
            element = waiting.pop()
            yield element
            waiting.extend(reversed(element.children))


def parse_xml(content: bytes, path: PathLike) -> Element:
    """Return the root of the XML in ``content``; ``path`` is what messages call it.

    Raises :class:`FileError`: it is not well-formed, declares a document type, or is beyond a bound; with the line.
    """
    if len(content) > MOST_BYTES:
        raise FileError(path, f"has {len(content):,} bytes, more than the {MOST_BYTES:,} allowed")
    builder = _Builder(path)
    try:
        builder.parser.Parse(content, True)
    except expat.ExpatError as error:
        reason = expat.errors.messages.get(error.code, "syntax error") if error.code else "syntax error"
        reason = reason.replace("junk after document element", "something follows the end of the document")
        place = f"line {error.lineno}, column {error.offset + 1}"
        raise FileError(path, f"is not valid XML ({reason})", place) from error
    except (
        LookupError,
        ValueError,
        UnicodeError,
    ) as error:  # an encoding that is not known, or not text at all
        raise FileError(path, f"is in no encoding of text that can be read ({error})", "line 1") from error
    if builder.root is None:
        raise FileError(path, "holds no element", "line 1")
    return builder.root


class _Builder:
    """Builds the tree from the parser's events."""

    def __init__(self, path: PathLike) -> None:
        self.path = path
        self.root: Element | None = None
        self._open: list[Element] = []
        self._count = 0
        self.parser = expat.ParserCreate(namespace_separator=_SEPARATOR)
        self.parser.buffer_text = True
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = lambda _name: self._open.pop()
        self.parser.CharacterDataHandler = self._text
        self.parser.StartDoctypeDeclHandler = self._refuse
        # Never called where no document type is declared; said all the same, in case a parser is built otherwise.
        self.parser.EntityDeclHandler = self._refuse
        self.parser.ExternalEntityRefHandler = self._refuse_reference

    def _fail(self, reason: str) -> None:
        raise FileError(self.path, reason, f"line {self.parser.CurrentLineNumber}")

    def _refuse(self, *_: object) -> None:
        self._fail("declares a document type or an entity, which no file of this kind needs")

    def _refuse_reference(self, *names: str | None) -> int:
        self._refuse(*names)
        return 0

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        self._count += 1
        if self._count > MOST_ELEMENTS:
            self._fail(f"has more than {MOST_ELEMENTS:,} elements")
        if len(self._open) >= DEEPEST:
            self._fail(f"is nested deeper than {DEEPEST} elements")
        namespace, _, local = name.rpartition(_SEPARATOR)
        named = {key.rpartition(_SEPARATOR)[2]: value for key, value in attributes.items()}
        element = Element(local, namespace, named, self.parser.CurrentLineNumber)
        if self._open:
            self._open[-1].children.append(element)
        else:
            self.root = element
        self._open.append(element)

    def _text(self, text: str) -> None:
        if self._open:
            self._open[-1].parts.append(text)


_NO_XML = re.compile("[^\t\n -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def clean_text(text: str) -> str:
    """Return a text with U+FFFD for what XML does not know."""
    return _NO_XML.sub("\ufffd", text)


def attribute(text: str) -> str:
    """Return a text as the value of an attribute, with its quotes."""
    return quoteattr(clean_text(text))


def text_content(text: str) -> str:
    """Return a text as the content of an element."""
    return escape(clean_text(text))


def read_root(data: bytes, path: PathLike, *names: str) -> Element:
    """Return the root of an XML file, which must have one of these local names.

    Raises :class:`FileError`: it is damaged, hostile (a document type, too deep), or something else; with the line.
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
