"""Draws pictures of paints, asked for line by line: a process of its own beside a program with a window.

A driver that fails takes this process with it and nothing else, and nothing here holds up a window. Each line in is a
request ``{"id", "look", "items"}``: ``look`` as :meth:`SwatchLook.to_json` has it, each item ``{"key", "paint"}`` or
``{"key", "flat"}`` with the object of a palette's file, ``key`` being whatever the asker knows it by. Each line out is
an answer: for every item ``{"id", "key", "picture"}`` with the pixels as base64 (RGB, 8 bits, size squared, top row
first) or ``{"id", "key", "refused"}`` where there is no such picture; ``{"id", "done"}`` after a request's last,
``{"id", "failed"}`` where the light cannot be loaded; ``{"unavailable"}`` where nothing can be drawn on this machine,
after which it ends. What is kept on disk is taken from there, and what is drawn is put there. It ends when its input is
closed.
"""

from __future__ import annotations

import base64
import json
import os
import sys
from collections.abc import Iterator, Mapping
from typing import Any, TextIO

from brdf_suite.errors import GraphicsError, SuiteError
from brdf_suite.pipeline.swatch_look import Content, SwatchLook, swatch_key
from brdf_suite.pipeline.swatch_pictures import SwatchPainter
from brdf_suite.pipeline.swatch_store import SwatchStore

BATCH = 32
"""Pictures that are drawn before any is answered: a batch is read back at once."""
_NICER = 12

Answer = dict[str, object]


class SwatchServer:
    """Answers requests from the store and by the painter; use it with ``with``."""

    def __init__(self, store: SwatchStore | None = None) -> None:
        self._store = store or SwatchStore()
        self._painter = SwatchPainter()

    def __enter__(self) -> SwatchServer:
        return self

    def __exit__(self, *_: object) -> None:
        self._painter.close()
        self._store.close()

    def answers(self, request: Mapping[str, Any]) -> Iterator[Answer]:
        """Yield the answers to a request; see the module."""
        name = request.get("id")
        try:
            look = SwatchLook.from_json(request["look"])
        except SuiteError as error:
            for item in request["items"]:
                yield {"id": name, "key": item.get("key"), "refused": str(error)}
            yield {"id": name, "done": True}
            return
        items = list(request["items"])
        for start in range(0, len(items), BATCH):
            for key, found in self._batch(items[start : start + BATCH], look):
                if isinstance(found, str):
                    yield {"id": name, "key": key, "refused": found}
                else:
                    yield {"id": name, "key": key, "picture": base64.b64encode(found).decode("ascii")}
        yield {"id": name, "done": True}

    def _batch(
        self, items: list[Mapping[str, Any]], look: SwatchLook
    ) -> Iterator[tuple[object, bytes | str]]:
        contents: dict[str, Content] = {}
        asked: list[tuple[object, str | None, str]] = []
        for item in items:
            try:
                content = _content(item)
                own = swatch_key(content, look)
                contents[own] = content
                asked.append((item.get("key"), own, ""))
            except SuiteError as error:
                asked.append((item.get("key"), None, str(error)))
        found: dict[str, bytes | str] = {
            key: pixels.tobytes() for key, pixels in self._store.get(contents).items()
        }
        missing = [key for key in contents if key not in found]
        drawn = self._painter.draw([contents[key] for key in missing], look) if missing else []
        self._store.put({picture.key: picture.pixels for picture in drawn if picture.pixels is not None})
        for picture in drawn:
            found[picture.key] = picture.problem if picture.pixels is None else picture.pixels.tobytes()
        for key, own_key, problem in asked:
            yield key, problem if own_key is None else found[own_key]


def _content(item: Mapping[str, Any]) -> Content:
    from brdf_suite.documents.palette_store import entry_from_json

    return entry_from_json(
        {name: item[name] for name in ("paint", "flat") if name in item}, "the request"
    ).content


def serve(lines: TextIO, out: TextIO, store: SwatchStore | None = None) -> None:
    """Answer requests until there are no more."""
    with SwatchServer(store) as server:
        for line in lines:
            try:
                for answer in server.answers(json.loads(line)):
                    out.write(json.dumps(answer) + "\n")
                    out.flush()
            except GraphicsError as error:
                out.write(json.dumps({"unavailable": str(error)}) + "\n")
                out.flush()
                return
            except SuiteError as error:  # the light's file: told for the whole request
                out.write(json.dumps({"id": json.loads(line).get("id"), "failed": str(error)}) + "\n")
                out.flush()


def main() -> None:
    """Run the process."""
    if hasattr(os, "nice"):
        os.nice(_NICER)  # the window goes first
    # Whatever prints, the answers' channel stays clean.
    out = os.fdopen(os.dup(sys.stdout.fileno()), "w", encoding="utf-8")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    serve(sys.stdin, out)


if __name__ == "__main__":
    main()
