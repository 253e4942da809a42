"""What ``import brdf_suite`` offers: names, signatures, examples, and that it costs nothing until it is used."""

from __future__ import annotations

import doctest
import importlib
import inspect
import os
import pkgutil
import re
import subprocess
import sys
from pathlib import Path

import pytest

import brdf_suite as bs

SIGNATURES = Path(__file__).with_name("signatures.txt")
CONSTANTS = {"version", "__version__"}
RESULTS = {"Drawing", "LobeFit", "Rendering"}  # made by functions, not by users
FUNCTIONS_AND_CLASSES = sorted(set(bs.__all__) - CONSTANTS)
GUESSED = [
    "load",
    "read",
    "Paint",
    "Palette",
    "Material",
    "Environment",
    "fit",
    "fit_cook_torrance",
    "factorize",
    "prefilter",
    "render",
    "measure",
    "compare",
    "check",
    "export",
    "convert",
    "acquire",
    "delta_e",
    "find_nearest",
    "read_palette",
    "save",
    "plot",
    "show",
    "simulate",
]
MEANT = {"read": "load", "read_palette": "load", "show": "plot"}


def in_a_fresh_process(statement: str) -> str:
    done = subprocess.run(
        [sys.executable, "-c", statement], capture_output=True, text=True, check=True, timeout=240
    )
    return done.stdout


def test_importing_loads_neither_numpy_nor_any_room() -> None:
    before = set(in_a_fresh_process("import sys; print(*sys.modules)").split())
    loaded = set(in_a_fresh_process("import sys, brdf_suite; print(*sys.modules)").split()) - before
    assert {name for name in loaded if name.startswith("brdf_suite")} == {"brdf_suite"}
    assert not loaded & {"numpy", "scipy", "PIL", "importlib.metadata"}


def test_a_name_loads_its_own_room_alone() -> None:
    loaded = in_a_fresh_process("import sys, brdf_suite as bs; bs.Paint; print(*sys.modules)").split()
    assert "brdf_suite.documents.paint" in loaded
    assert not {"numpy", "brdf_suite.library.fits", "moderngl"} & set(loaded)


@pytest.mark.parametrize("name", GUESSED)
def test_a_guessed_name_is_there_or_is_answered_with_the_right_one(name: str) -> None:
    if name not in MEANT:
        assert vars(bs).get(name) or getattr(bs, name)
        return
    with pytest.raises(AttributeError, match=f"did you mean '{MEANT[name]}'"):
        getattr(bs, name)


@pytest.mark.parametrize(
    ("typed", "meant"),
    [("rendr", "render"), ("paint", "Paint"), ("deltaE", "delta_e"), ("fit_cooktorrance", "fit_c")],
)
def test_a_slip_of_the_pen_is_answered_with_the_right_name(typed: str, meant: str) -> None:
    with pytest.raises(AttributeError, match=f"did you mean '{meant}"):
        getattr(bs, typed)


def test_a_name_like_no_other_is_answered_with_all_names() -> None:
    with pytest.raises(AttributeError, match=r"there are .*factorize.*simulate"):
        bs.zzzz  # noqa: B018


def test_the_signatures_are_those_that_were_promised() -> None:
    lines = [f"version: {type(bs.version).__name__}"]
    for name in FUNCTIONS_AND_CLASSES:
        found = getattr(bs, name)
        if inspect.isclass(found) and issubclass(found, Exception):
            lines.append(f"{name}: exception")
            continue
        lines.append(name if name in RESULTS else name + _signature(found))
        if inspect.isclass(found):
            own = {
                key: value
                for kind in reversed(found.__mro__[:-1])
                for key, value in vars(kind).items()
                if not key.startswith("_")
            }
            own |= dict.fromkeys(getattr(found, "__dataclass_fields__", {}))
            for key, value in sorted(own.items()):
                lines.append(f"    {key}{_signature(value) if callable(value) else ''}")
    text = "\n".join(lines) + "\n"
    if os.environ.get("BRDF_SUITE_RENEW_GOLDEN"):
        SIGNATURES.write_text(text)
    assert text == SIGNATURES.read_text()


def _signature(function: object) -> str:
    """Return a signature with annotations as they are written, and without modules."""
    signature = inspect.signature(function)  # type: ignore[arg-type]
    taken = [
        one.replace(annotation=_Written(one.annotation)) if isinstance(one.annotation, str) else one
        for one in signature.parameters.values()
    ]
    returned = signature.return_annotation
    shown = signature.replace(
        parameters=taken, return_annotation=_Written(returned) if isinstance(returned, str) else returned
    )
    return re.sub(r"<factory>|<object object at 0x\w+>", "...", str(shown))


class _Written(str):
    """An annotation that is shown without quotes."""

    __slots__ = ()

    def __repr__(self) -> str:
        return str(self)


@pytest.mark.parametrize("name", FUNCTIONS_AND_CLASSES)
def test_every_name_has_an_example_that_runs(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    value = getattr(bs, name)
    module = importlib.import_module(value.__module__)
    found = doctest.DocTestFinder(recurse=False).find(value, name, module=module)
    examples = [example for test in found for example in test.examples]
    assert examples, f"{name} has no example"
    assert any("bs." in example.source for example in examples)
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
    output: list[str] = []
    for test in found:
        runner.run(test, out=output.append)
    assert not runner.failures, "".join(output)


def test_no_module_is_called_like_a_function_of_the_library_that_it_defines() -> None:
    names = {name for name in FUNCTIONS_AND_CLASSES if inspect.isfunction(getattr(bs, name))}
    folder = Path(bs.__file__).parent
    assert not names & {one.name for one in pkgutil.iter_modules([str(folder)])}
    called = [path for path in folder.rglob("*.py") if path.stem in names]
    defining = [path for path in called if re.search(rf"^def {path.stem}\(", path.read_text(), re.MULTILINE)]
    assert [path.name for path in defining] == []


def test_the_library_is_typed() -> None:
    assert (Path(bs.__file__).parent / "py.typed").is_file()


SCRIPT = """
import brdf_suite as bs

blue = bs.load("blue", bs.Material)
reveal_type(blue.eval([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]))
reveal_type(bs.load("blue"))
reveal_type(bs.fit(blue).worst_delta_e)
reveal_type(bs.factorize("blue"))
reveal_type(bs.factorize([[0.0, 0.0, 1.0]], [[0.0, 0.0, 1.0]], [[0.1, 0.1, 0.1]]))
reveal_type(bs.render("blue").pixels)
reveal_type(bs.version)
bs.rendr("blue")
bs.render("blue", sise=(3, 4))
bs.load("booth", bs.Environment).radiance
"""


def test_a_type_checker_knows_the_types_of_a_users_script(tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(SCRIPT)
    done = subprocess.run(
        [
            *(sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent"),
            *("--cache-dir", str(Path(bs.__file__).parents[1] / ".mypy_cache" / "script"), str(script)),
        ],
        cwd=Path(bs.__file__).parents[1],
        capture_output=True,
        text=True,
        timeout=840,
        check=False,
    )
    said = done.stdout
    for expected in (
        "numpy.ndarray[",
        "material.Material | brdf_suite.documents.palette.Palette",
        "float | None",
        "reflectance_fit.FactoredFit",
        'Revealed type is "str"',
        'has no attribute "rendr"',
        'Unexpected keyword argument "sise"',
    ):
        assert expected in said, said
    assert said.count(": error:") == 2, said
