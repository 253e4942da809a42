"""Draws pictures of paints, asked for line by line: a process of its own beside a program with a window.

A driver that fails takes this process with it and nothing else, and nothing here holds up a window. Each line in is a
request ``{"id", "look", "items"}``: ``look`` as :meth:`SwatchLook.to_json` has it, each item ``{"key", "paint"}`` or
``{"key", "flat"}`` with the object of a palette's file, ``key`` being whatever the asker knows it by. Each line out is
an answer: for every item ``{"id", "key", "picture"}`` with the pixels as base64 (RGB, 8 bits, size squared, top row
first) or ``{"id", "key", "refused"}`` where there is no such picture, with ``"fault"`` for the log where that was a
fault of this program; ``{"id", "done"}`` after a request's last, ``{"id", "failed"}`` where the light cannot be loaded;
``{"id", "unavailable"}`` where nothing of this look can be drawn on this machine, after which it ends. What is kept on
disk is taken from there, and what is drawn is put there. It ends when its input is closed.
"""

from __future__ import annotations

import base64
import json
import os
import sys
import traceback
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, TextIO

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette_store import entry_from_json
from brdf_suite.errors import GraphicsError, SuiteError
from brdf_suite.palettes.swatches.look import Content, SwatchLook, swatch_key
from brdf_suite.palettes.swatches.pictures import SwatchPainter
from brdf_suite.palettes.swatches.store import SwatchStore

BATCH = 32
"""Pictures that are drawn before any is answered: a batch is read back at once."""
_NICER = 12

Answer = dict[str, object]


@dataclass(frozen=True)
class _Refusal:
    """Why there is no picture; ``fault`` is the trace of an unexpected error."""

    words: str
    fault: str = ""


_Found = bytes | _Refusal


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
                if isinstance(found, _Refusal):
                    fault = {"fault": found.fault} if found.fault else {}
                    yield {"id": name, "key": key, "refused": found.words, **fault}
                else:
                    yield {"id": name, "key": key, "picture": base64.b64encode(found).decode("ascii")}
        yield {"id": name, "done": True}

    def _batch(self, items: list[Mapping[str, Any]], look: SwatchLook) -> Iterator[tuple[object, _Found]]:
        contents: dict[str, Content] = {}
        asked: list[tuple[object, str | _Refusal]] = []
        for item in items:
            try:
                inside = {name: item[name] for name in ("paint", "flat") if name in item}
                content = entry_from_json(inside, "the request").content
                own = swatch_key(content, look)
                contents[own] = content
                asked.append((item.get("key"), own))
            except SuiteError as error:
                asked.append((item.get("key"), _Refusal(str(error))))
            except Exception as error:  # noqa: BLE001 - reported for this item; the others have their pictures
                asked.append((item.get("key"), _fault(error)))
        found: dict[str, _Found] = {
            key: pixels.tobytes() for key, pixels in self._store.get(contents).items()
        }
        missing = {key: content for key, content in contents.items() if key not in found}
        if missing:
            found.update(self._drawn(missing, look))
        for key, own_key in asked:
            yield key, own_key if isinstance(own_key, _Refusal) else found[own_key]

    def _drawn(self, contents: Mapping[str, Content], look: SwatchLook) -> dict[str, _Found]:
        """Return the pictures by their keys, and what is to be said of those that are none."""
        try:
            return self._draw(contents, look)
        except GraphicsError as error:
            # All of these, and perhaps them alone: only where nothing else is drawn either, this machine cannot.
            if not self._draws(look):
                raise
            return dict.fromkeys(contents, _Refusal(str(error)))
        except SuiteError:
            raise
        except Exception as error:  # noqa: BLE001 - each item is tried alone, and the error reported for its own
            if len(contents) == 1:
                return dict.fromkeys(contents, _fault(error))
        found: dict[str, _Found] = {}
        for key, content in contents.items():
            found.update(self._drawn({key: content}, look))
        return found

    def _draw(self, contents: Mapping[str, Content], look: SwatchLook) -> dict[str, _Found]:
        drawn = self._painter.draw(list(contents.values()), look)
        self._store.put({picture.key: picture.pixels for picture in drawn if picture.pixels is not None})
        return {
            one.key: _Refusal(one.problem) if one.pixels is None else one.pixels.tobytes() for one in drawn
        }

    def _draws(self, look: SwatchLook) -> bool:
        """Whether a plain grey is drawn."""
        try:
            (picture,) = self._painter.draw([solid_paint("grey", (50.0, 0.0, 0.0))], look)
        except GraphicsError:
            return False
        return picture.pixels is not None


def _fault(error: Exception) -> _Refusal:
    words = f"The program met a fault of its own: {type(error).__name__}: {error}"
    return _Refusal(words, "".join(traceback.format_exception(error)))


def serve(lines: TextIO, out: TextIO, store: SwatchStore | None = None) -> None:
    """Answer requests until there are no more."""

    def say(answer: Answer) -> None:
        out.write(json.dumps(answer) + "\n")
        out.flush()

    with SwatchServer(store) as server:
        for line in lines:
            try:
                for answer in server.answers(json.loads(line)):
                    say(answer)
            except GraphicsError as error:
                say({"id": json.loads(line).get("id"), "unavailable": str(error)})
                return
            except SuiteError as error:  # the light's file: reported for the whole request
                say({"id": json.loads(line).get("id"), "failed": str(error)})


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
