"""What a user is told of an environment: its size, what was assumed or repaired, what is missing, the cache."""

from __future__ import annotations

from brdf_suite.pipeline.scene import PreparedEnvironment


def environment_facts(prepared: PreparedEnvironment, loading: bool) -> str:
    """Return the lines under the chooser; ``loading``: whether the missing maps are on their way."""
    rows, columns = prepared.environment.radiance.shape[:2]
    lines = [f"{columns} × {rows} pixels", *map(_sentence, prepared.environment.notes)]
    if prepared.draft:
        lines.append("A draft; the light as it will be follows when the hand rests.")
    elif not prepared.is_final:
        made = prepared.wanted - prepared.missing
        what = f"{made} of {prepared.wanted} maps are there; "
        if loading:
            lines.append(what + "sharp reflections follow.")
        else:
            lines.append(what + "sharp reflections are wrong. Choose the light again to finish it.")
    return "\n".join([*lines, *prepared.notices])


def _sentence(text: str) -> str:
    """Return a note as a sentence: notes of files are phrases in lower case."""
    return text[:1].upper() + text[1:].rstrip(".") + "."
