"""Models written as text wherever a reflectance's file is taken: loaded, checked, fitted, converted, refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import brdf_suite as bs
from brdf_suite.cli.main import main
from brdf_suite.errors import FileError
from brdf_suite.files.measured import read_measured, sniff

GLSL = """analytic
::begin parameters
float n 1 99 20
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y)
{
    return vec3(0.05) + pow(max(dot(N, normalize(L + V)), 0.0), n);
}
::end shader
"""
PYTHON = """def brdf(L, V, N, X, Y, n=number(1, 99, 20)):
    return 0.05 + max(dot(N, normalize(L + V)), 0) ** n
"""


@pytest.mark.parametrize(("name", "text"), [("a.brdf", GLSL), ("a.py", PYTHON), ("without_ending", GLSL)])
def test_a_text_is_a_reflectance_like_others(tmp_path: Path, name: str, text: str) -> None:
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    assert sniff(path).name == "model_text"
    found = bs.load(path, bs.Material)
    np.testing.assert_allclose(found.eval([0.6, 0.0, 0.8], [-0.6, 0.0, 0.8]), 1.05, rtol=1e-5)
    fit = bs.fit(path)
    seen = fit.weights.eval(np.array([0.6, 0.0, 0.8]), np.array([-0.6, 0.0, 0.8]))
    np.testing.assert_allclose(seen, 1.05, rtol=0.1)
    assert main(["convert", str(path), "-o", str(tmp_path / "a.brdftable")]) == 0
    table = read_measured(tmp_path / "a.brdftable")
    np.testing.assert_allclose(table.eval([0.6, 0.0, 0.8], [-0.6, 0.0, 0.8]), 1.05, rtol=0.02)


def test_errors_name_file_and_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "a.brdf"
    path.write_text(GLSL.replace("pow(", "power("), encoding="utf-8")
    assert main(["fit", str(path)]) == 1
    assert f"{path}, at line 8: " in capsys.readouterr().err
    path.write_bytes(GLSL.encode() + b"\xff")
    with pytest.raises(FileError, match="UTF-8"):
        read_measured(path)
