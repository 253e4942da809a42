"""Find the files of tests that a change can reach, from what each file imports and names.

Standard library only. A Python file depends on the modules that it imports anywhere (and the packages above them),
on the modules that its strings name (children started with ``python -m``, code for another process, patched
names), and on the files that its strings name by their own name, by a pattern, or by a folder of data. Data of a
package also belong to the modules beside them, and a ``conftest.py`` to all below it. What is installed
(``brdf_suite/``, ``apps/``, ``resources/``) depends on nothing else, and not on the programs that it can start: a
test in which one runs names that program, by its package, its script, or its word after ``brdf-suite``.
"""

from __future__ import annotations

import ast
import re
import subprocess
from collections.abc import Iterable
from dataclasses import dataclass
from fnmatch import fnmatch
from pathlib import Path, PurePosixPath

EVERYTHING = frozenset({"pyproject.toml", "packaging/lock.txt"})
"""Files that every test depends on."""

_INSTALLED = ("brdf_suite/", "apps/", "resources/")
_NAMELESS = ("__init__.py", "__main__.py", "conftest.py")
_NAME = re.compile(r"[A-Za-z_]\w*(?:\.\w+)*\.?")
_LONGEST_PATH = 200


@dataclass(frozen=True)
class Selection:
    """Files of tests (``None``: all of them), and the reason in a few words."""

    tests: tuple[str, ...] | None
    reason: str


def changed_files(root: Path, reference: str | None = None) -> list[str]:
    """List the files, relative to ``root``, that differ from a commit: committed since, edited, deleted, new.

    Without ``reference`` the commit is where this branch left ``main``, or ``HEAD`` where there is no ``main``.
    Raises :class:`ValueError` where git knows no such commit.
    """
    if reference is None:
        commit = _git(root, "merge-base", "HEAD", "main") or _git(root, "rev-parse", "--verify", "HEAD")
    else:
        commit = _git(root, "rev-parse", "--verify", f"{reference}^{{commit}}")
    if not commit:
        raise ValueError(f"git knows no commit {reference or 'HEAD'} in {root}")
    edited = _git(root, "diff", "--name-only", "--no-renames", "-z", commit[0])
    return sorted({*edited, *_git(root, "ls-files", "--others", "--exclude-standard", "-z")})


def select(root: Path, changed: Iterable[str]) -> Selection:
    """Select the files of tests that a change of ``changed`` (paths relative to ``root``) can reach."""
    changed = sorted(set(changed))
    for file in changed:
        if file in EVERYTHING:
            return Selection(None, f"everything depends on {file}")
    users = _users(root, {*changed, *_files(root)})
    tests = {file for file in users if _is_test(file) and (root / file).is_file()}
    selected: set[str] = set()
    for file in changed:
        reached = _reached(file, users) & tests
        if not reached:
            room = _stand_in(file)
            if room is None:
                return Selection(None, f"nothing says which tests depend on {file}")
            reached = {test for test in tests if test.startswith(room)}
        selected |= reached
    reason = f"{len(changed)} changed files reach {len(selected)} of the {len(tests)} files of tests"
    return Selection(tuple(sorted(selected)), reason)


def _users(root: Path, files: Iterable[str]) -> dict[str, set[str]]:
    """Return for each file those that depend on it directly; what is gone still has users."""
    checkout = _Checkout(root, files)
    users: dict[str, set[str]] = {file: set() for file in checkout.files}
    for file in checkout.files:
        for used in checkout.used_by(file):
            users[used].add(file)
    return users


def _reached(file: str, users: dict[str, set[str]]) -> set[str]:
    found, waiting = {file}, [file]
    while waiting:
        more = users[waiting.pop()] - found
        found |= more
        waiting.extend(more)
    return found


def _stand_in(file: str) -> str | None:
    """Return the start of the paths of the tests to run for a file that none is known to use; ``None``: of all."""
    parts = PurePosixPath(file).parts
    if parts[0] == "tests" and len(parts) > 2:
        return f"tests/{parts[1]}/"
    if parts[0] in ("docs", "packaging") or file.endswith(".md"):
        return "tests/packaging/"
    return None


class _Checkout:
    """The files of a checkout, and the names by which one uses another."""

    def __init__(self, root: Path, files: Iterable[str]) -> None:
        self.root = root
        self.files = frozenset(files)
        self._modules = {name: file for file in self.files if (name := _module(file))}
        # A word such as "factored.json" is no module of the script factored.py.
        self._top = {file for name, file in self._modules.items() if "." not in name}
        self._begins: dict[str, set[str]] = {}
        for name, file in self._modules.items():
            for end in (place for place, letter in enumerate(name) if letter == "."):
                self._begins.setdefault(name[: end + 1], set()).add(file)
        code = {PurePosixPath(file).parent for file in self.files if file.endswith(".py")}
        self._names: dict[str, set[str]] = {}
        self._folders: dict[str, set[str]] = {}
        self._beside: dict[PurePosixPath, set[str]] = {}
        for file in self.files:
            path = PurePosixPath(file)
            if path.name not in _NAMELESS:
                self._names.setdefault(path.name, set()).add(file)
            for folder in set(path.parents[:-1]) - code:
                self._folders.setdefault(folder.name, set()).add(file)
            if path.suffix != ".py" and file.startswith(_INSTALLED):
                folder = next((above for above in path.parents if above in code), path.parent)
                self._beside.setdefault(folder, set()).add(file)
        self._programs = {name.partition(".")[0] for name in self._modules if name.endswith(".__main__")}
        self._scripts = self._read_scripts()

    def used_by(self, file: str) -> set[str]:
        """Return the other files that one depends on directly."""
        path = PurePosixPath(file)
        found = {str(above / "conftest.py") for above in path.parents} & self.files
        if path.suffix == ".py" and (self.root / file).is_file():
            found |= self._beside.get(path.parent, set())
            try:
                tree = ast.parse((self.root / file).read_bytes())
            except SyntaxError:
                return found - {file}
            imported, strings = _imports_and_strings(tree, file)
            found.update(*(self._of_module(name) for name in imported))
            found.update(*(self._named(text, path) for text in strings))
            if file.startswith(_INSTALLED):
                found = {used for used in found if used.startswith(_INSTALLED)}
        return found - {file}

    def _of_module(self, name: str) -> set[str]:
        """Return the file of a module, or of the one in which ``name`` is, and those of the packages above."""
        parts = name.split(".")
        above = (".".join(parts[: end + 1]) for end in range(len(parts)))
        return {self._modules[module] for module in above if module in self._modules}

    def _named(self, text: str, user: PurePosixPath) -> set[str]:
        """Return the files of which a string of the file ``user`` gives the name, and those of modules."""
        found: set[str] = set()
        installed = str(user).startswith(_INSTALLED)
        if not installed and text in self._scripts:
            found |= self._of_module(self._scripts[text])
        for word in _NAME.findall(text):
            if word in self._programs:
                found |= set() if installed else self._of_module(f"{word}.__main__")
            elif "." in word:  # a word alone may be any word; one that ends in a dot goes on when it runs
                found |= self._begins.get(word, set()) | self._of_module(word.rstrip(".")) - self._top
        last = text.rstrip("/").rpartition("/")[2]
        if not last.strip(".") or len(text) > _LONGEST_PATH:
            return found
        found |= self._names.get(last, set()) | self._folders.get(last, set())
        found |= {str(user.parent / f"{last}.py")} & self.files
        if re.search(r"[*].*[.]\w", last):
            fitting = {file for name in self._names if fnmatch(name, last) for file in self._names[name]}
            # "*.py" means the files of some folder: that of the module which says so.
            wide = last.startswith("*.")
            found |= (
                {file for file in fitting if PurePosixPath(file).parent == user.parent} if wide else fitting
            )
        return found

    def _read_scripts(self) -> dict[str, str]:
        """Return the modules of the commands, by their names and by the words after ``brdf-suite`` for them."""
        try:
            project = (self.root / "pyproject.toml").read_text(encoding="utf-8")
        except OSError:
            return {}
        modules = dict(re.findall(r'^(brdf-[\w-]+) = "([\w.]+):\w+"$', project, re.MULTILINE))
        return modules | {name.removeprefix("brdf-"): module for name, module in modules.items()}


def _imports_and_strings(tree: ast.AST, file: str) -> tuple[set[str], set[str]]:
    """Return the names that a module imports, and its strings without docstrings, with parts of formatted ones."""
    package = _module(file).split(".")[: None if file.endswith("/__init__.py") else -1]
    imported: set[str] = set()
    strings: list[ast.Constant] = []
    documents: set[int] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            imported.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            above = package[: len(package) - node.level + 1] if node.level else []
            imported.update(
                ".".join([*above, *filter(None, [node.module]), alias.name]) for alias in node.names
            )
        elif isinstance(node, ast.Expr):
            documents.add(id(node.value))
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            strings.append(node)
    return imported, {str(node.value) for node in strings if id(node) not in documents}


def _module(file: str) -> str:
    """Return the name by which Python finds a file, else nothing; a script's is that of its file."""
    path = PurePosixPath(file)
    if path.suffix != ".py" or _is_test(file):
        return ""
    if path.parts[:3] == ("packaging", "generators", "meshes"):
        return ".".join((path.parent if path.name == "__init__.py" else path.with_suffix("")).parts[2:])
    if path.parts[0] in ("tests", "packaging"):
        return "" if path.name in _NAMELESS else path.stem
    parts = path.parent.parts if path.name == "__init__.py" else path.with_suffix("").parts
    return ".".join(parts[1:] if parts and parts[0] == "apps" else parts)


def _is_test(file: str) -> bool:
    return file.startswith("tests/") and fnmatch(PurePosixPath(file).name, "test_*.py")


def _files(root: Path) -> list[str]:
    """List the files of the checkout; without git those of the folders that matter."""
    tracked = _git(root, "ls-files", "--cached", "--others", "--exclude-standard", "-z")
    folders = (*_INSTALLED, "packaging/", "tools/", "docs/", "tests/")
    return tracked or [
        path.relative_to(root).as_posix()
        for folder in folders
        for path in (root / folder).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    ]


def _git(root: Path, *arguments: str) -> list[str]:
    """Return what git prints, cut at ends of lines or zeros; nothing where it fails or is missing."""
    try:
        done = subprocess.run(["git", *arguments], cwd=root, capture_output=True, text=True, check=False)
    except OSError:
        return []
    return re.findall(r"[^\0\n]+", done.stdout) if done.returncode == 0 else []
