"""What ``import brdf_suite`` offers: names, signatures, examples, and that it costs nothing until it is used."""

from __future__ import annotations

import doctest
import functools
import importlib
import inspect
import os
import pkgutil
import re
import subprocess
import sys
import typing
from pathlib import Path

import pytest

import brdf_suite as bs
from brdf_suite.acquisition.reconstruction.table import Acquired
from brdf_suite.lighting.filter.face_array import FaceArray

SIGNATURES = Path(__file__).with_name("signatures.txt")
CONSTANTS = {"version", "__version__"}
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


def _classes_in(hint: object) -> set[type]:
    """Return the suite's own classes in an annotation."""
    if inspect.isclass(hint) and not typing.get_args(hint):
        return {hint} if hint.__module__.startswith("brdf_suite.") else set()
    return {kind for inner in typing.get_args(hint) for kind in _classes_in(inner)}


def _results() -> dict[str, type]:
    """Return the classes that functions return, by their names: made by functions, not by users."""
    functions = [getattr(bs, name) for name in FUNCTIONS_AND_CLASSES]
    found = {
        kind
        for one in functions
        if inspect.isfunction(one)
        for kind in _classes_in(typing.get_type_hints(one, None, {"Acquired": Acquired})["return"])
    }
    found.add(FaceArray)  # the maps of what prefilter returns
    return {kind.__name__: kind for kind in found if kind not in (bs.Material, bs.Palette)}


RESULTS = _results()


def _methods() -> dict[str, object]:
    """Return the public methods of public classes and of results, as ``Palette.entry``."""
    classes = {
        name: getattr(bs, name) for name in FUNCTIONS_AND_CLASSES if inspect.isclass(getattr(bs, name))
    }
    return {
        f"{name}.{key}": method
        for name, kind in sorted((classes | RESULTS).items())
        for owner in kind.__mro__
        for key, method in vars(owner).items()
        if inspect.isfunction(method)
        and not key.startswith("_")
        and owner.__module__.startswith("brdf_suite.")
    }


METHODS = _methods()


def in_a_fresh_process(statement: str) -> str:
    done = subprocess.run(
        [sys.executable, "-c", statement], capture_output=True, text=True, check=True, timeout=240
    )
    return done.stdout


def test_importing_loads_neither_numpy_nor_any_room() -> None:
    before = set(in_a_fresh_process("import sys; print(*sys.modules)").split())
    loaded = set(in_a_fresh_process("import sys, brdf_suite; print(*sys.modules)").split()) - before
    assert {name for name in loaded if name.startswith("brdf_suite")} == {"brdf_suite", "brdf_suite.release"}
    assert not loaded & {"numpy", "scipy", "PIL", "importlib.metadata"}


def test_help_shows_every_name_where_no_extra_is_installed() -> None:
    hidden = (
        "import sys; sys.modules |= dict.fromkeys(('numba', 'cv2', 'rawpy', 'mitsuba', 'imageio_ffmpeg'))"
    )
    text = in_a_fresh_process(
        f"{hidden}; import pydoc, brdf_suite; print(pydoc.plaintext.document(brdf_suite))"
    )
    assert [name for name in FUNCTIONS_AND_CLASSES if name not in text] == []
    assert "Reconstruct a table of half-angle bins from photographs" in text


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
    for name in sorted({*FUNCTIONS_AND_CLASSES, *RESULTS}):
        found = RESULTS.get(name) or getattr(bs, name)
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


@pytest.mark.parametrize("name", ["brdf_suite", *FUNCTIONS_AND_CLASSES, *METHODS])
def test_every_name_and_every_method_has_an_example_that_runs(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    value = bs if name == "brdf_suite" else METHODS[name] if "." in name else getattr(bs, name)
    module = importlib.import_module(getattr(value, "__module__", name))
    found = doctest.DocTestFinder(recurse=False).find(value, name, module=module)
    examples = [example for test in found for example in test.examples]
    assert examples, f"{name} has no example"
    assert any("bs." in example.source for example in examples)
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
    output: list[str] = []
    for test in found:
        runner.run(test, out=output.append)
    assert not runner.failures, "".join(output)


@pytest.mark.parametrize("name", [*FUNCTIONS_AND_CLASSES, *METHODS])
def test_every_parameter_is_documented(name: str) -> None:
    value = METHODS[name] if "." in name else getattr(bs, name)
    if name in RESULTS or (inspect.isclass(value) and issubclass(value, Exception)):
        return
    text = inspect.getdoc(value) or ""
    taken = [one for one in inspect.signature(value).parameters if one not in ("self", "progress")]
    assert [one for one in taken if not re.search(rf"\b{one}\b", text)] == []


def test_every_property_is_documented() -> None:
    classes = [getattr(bs, name) for name in FUNCTIONS_AND_CLASSES] + [*RESULTS.values()]
    bare = [
        f"{kind.__name__}.{key}"
        for kind in classes
        if inspect.isclass(kind)
        for key, value in vars(kind).items()
        if isinstance(value, (property, functools.cached_property)) and not (value.__doc__ or "").strip()
    ]
    assert bare == []


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
