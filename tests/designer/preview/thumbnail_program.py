"""Stands in for the process that draws pictures: answers as its argument says, without drawing."""

from __future__ import annotations

import base64
import json
import sys

from brdf_designer.preview.thumbnail_scene import SIZE

mode = sys.argv[1]
for number, line in enumerate(sys.stdin):
    request = json.loads(line)
    if mode == "dies":
        sys.exit(3)
    if mode == "dies once" and number == 1:
        sys.exit(3)
    answer = {"key": request["key"]}
    if mode == "no graphics":
        answer = {"unavailable": "No OpenGL 3.3 context could be made."}
    elif request["paint"]["name"] == "impossible":
        answer["refused"] = "No clearcoat gives this gloss."
    else:
        level = round(2.5 * request["paint"]["measurements"][0]["lab"][0]) % 256
        answer["picture"] = base64.b64encode(bytes([level]) * (3 * SIZE * SIZE)).decode("ascii")
    sys.stdout.write(json.dumps(answer) + "\n")
    sys.stdout.flush()
