"""Measure the structure of the checkout, and check the rules that keep it: ``tools/house.py [--json | --check]``.

``--json`` prints the figures, ``--check`` names every place that breaks a rule and ends with status 1. A rule that does
not hold yet has a number in :data:`ALLOWED`: its breaches may become fewer, never more.
"""

from __future__ import annotations

import argparse
import ast
import json
import re
import sys
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

MODULES_IN_A_FOLDER = 20
SIBLINGS_WITH_ONE_PREFIX = 3
SHARED_CLASS_NAMES = 20
PRIVATE_ACCESSES_IN_TESTS = 60
LONG_FILE = 500

# Breaches of each rule that there are today. Lower a number when breaches go; a rule without a number has none.
ALLOWED: dict[str, int] = {
    "imports inside functions": 62,
    "attributes by text": 5,
}

OPTIONAL_PACKAGES = {"cv2", "drjit", "flip_evaluator", "imageio_ffmpeg", "mitsuba", "numba", "rawpy"}

# Modules that may import inside functions, with the reason: what the import takes of the processor's time where it is
# not needed.
_INTERRUPTED = "an interrupt may come before it"
LATE_IMPORTS: dict[str, str] = {
    "apps/brdf_color_swatch/__main__.py": _INTERRUPTED,
    "apps/brdf_designer/__main__.py": _INTERRUPTED,
    "apps/brdf_lobe_visualizer/__main__.py": _INTERRUPTED,
    "apps/brdf_viewer/__main__.py": _INTERRUPTED,
    "apps/brdf_designer/command_line.py": "all of Designer: the start page is on the screen before it",
    "apps/brdf_designer/acquire/control.py": "80 ms, when the assistant is opened for the first time",
    "apps/brdf_designer/acquire/exposures/control.py": "0.2 s with numba, on a thread",
    "apps/brdf_designer/acquire/mask/control.py": "0.2 s with numba, on a thread",
    "apps/brdf_designer/acquire/camera_response/work.py": "0.6 s with numba and scipy.optimize, on a thread",
    "apps/brdf_designer/acquire/session/control.py": "0.2 s with numba, on a thread",
    "apps/brdf_designer/acquire/reconstruction/work.py": "0.6 s with numba and scipy.optimize, on a thread",
    "apps/brdf_designer/colour/angle_plot.py": "pyqtgraph: 140 ms, after the window is painted",
    "apps/brdf_designer/export/control.py": "60 ms, on a thread",
    "apps/brdf_designer/from_measurement/control.py": "50 ms, when a file is opened",
    "apps/brdf_designer/from_measurement/section.py": "20 ms, when a file is asked for",
    "apps/brdf_designer/picture/control.py": "the renderer, 80 ms, only on a screen with OpenGL; files, when painted",
    "apps/brdf_lobe_visualizer/model_text/part.py": "models, 40 ms, after the window is painted",
    "apps/brdf_qt/program/diagnostics.py": "importlib.metadata and platformdirs take 20 ms each",
    "apps/brdf_viewer/tracing/engines.py": "Mitsuba is optional, and the process that traces must live to report it",
    "brdf_suite/__main__.py": _INTERRUPTED,
    "brdf_suite/documents/store.py": "OpenEXR is loaded for the textures of factored paints alone",
    "brdf_suite/files/images/icc.py": "Pillow's littleCMS takes 25 ms, and few monitors need it",
    "brdf_suite/files/palettes/cmyk_profile.py": "Pillow's littleCMS takes 25 ms, and few palettes need it",
    "brdf_suite/fitting/lobes/background.py": "concurrent.futures loads logging, and a program may start without a fit",
    "brdf_suite/fitting/lobes/measured_samples.py": "scipy.spatial takes 0.5 s, and only measured data need it",
    "brdf_suite/fitting/lobes/highs_model.py": "highspy takes 20 ms, and a program may start without a fit",
    "brdf_suite/library/__init__.py": "numpy, where a notebook shows a value",
    "brdf_suite/library/photographs.py": "Numba is optional, and help() looks at every name of the library",
    "brdf_suite/library/pictures.py": "Mitsuba is optional, and the ray tracer is not needed for other pictures",
    "brdf_suite/paint_design/feasible_colours.py": "scipy.optimize takes half a second, and few edits need it",
    "brdf_suite/paint_design/standard_files.py": "the readers take 60 ms, and few starts read a standard",
    "brdf_suite/plugins.py": "importlib.metadata takes 30 to 90 ms, and few starts read a table of plug-ins",
    "brdf_suite/processes.py": "multiprocessing takes 10 ms, and only pools need it",
    "brdf_suite/reflectance/blocks.py": "concurrent.futures loads logging, and small calls need no threads",
    "brdf_suite/reflectance/factored/model.py": "OpenEXR is loaded for the textures of factored paints alone",
    "brdf_suite/reflectance/tabulated/scattered.py": "scipy.spatial takes 0.5 s, and only scattered data need it",
    "brdf_suite/reports/contact_sheet/document.py": "reportlab takes 120 ms, and only PDF needs it",
    "brdf_suite/reports/paint_report/formats.py": "reportlab takes 120 ms, and only PDF needs it",
    "brdf_suite/surface/normals.py": "scipy.sparse takes 300 ms, and only meshes without normals need it",
    "brdf_suite/surface/occlusion/bake.py": "scipy.sparse takes 300 ms, and only baking needs it",
    "brdf_suite/surface/occlusion/rays.py": "Embree's library takes 40 ms to load, and only baking needs it",
    "brdf_suite/tracing/turntable.py": "Mitsuba is optional, and a missing ffmpeg is reported before it",
}

# Modules that open files, start processes or reach outside in other ways than by the functions for it
# (``brdf_suite/regular_files.py``, ``brdf_suite/documents/atomic.py``, ``brdf_suite/processes.py``), with the reason.
_SHIPPED = "a file that is installed with the suite"
_OWN_COPY = "a file that this process or its child has just written"
_CHILD = "starts what child_command names"
DIRECT_ACCESS: dict[str, str] = {
    "apps/brdf_color_swatch/library/autosave.py": "a draft that is renamed; it has no name before",
    "apps/brdf_qt/documents/open_tabs.py": "a draft that is renamed; it has no name before",
    "apps/brdf_qt/documents/recovery.py": "a draft that is renamed; it has no name before",
    "apps/brdf_qt/gl/items.py": _SHIPPED,
    "apps/brdf_qt/link/open_files.py": "the local socket for files of a file manager",
    "apps/brdf_qt/link/link.py": "the local socket of the live link",
    "apps/brdf_qt/program/application.py": "the kernel's figures of this process, and a pair of sockets for signals",
    "apps/brdf_qt/program/icons.py": _SHIPPED,
    "apps/brdf_qt/program/monitor_profile.py": "the monitor's profile, from the window system",
    "apps/brdf_qt/program/suite.py": _CHILD,
    "apps/brdf_qt/start/gallery.py": _SHIPPED,
    "apps/brdf_qt/window/manual.py": _SHIPPED,
    "apps/brdf_qt/window/placement.py": "a few bytes of this process alone",
    "apps/brdf_qt/work/command_process.py": _CHILD + ", and reads what it writes",
    "apps/brdf_qt/work/pictures.py": _CHILD,
    "apps/brdf_viewer/tracing/picture_slots.py": _OWN_COPY,
    "apps/brdf_viewer/tracing/scene_files.py": _OWN_COPY,
    "brdf_suite/batches/journal.py": "the journal, to which lines are appended",
    "brdf_suite/processes.py": "the null device, in the place of a standard stream that is closed",
    "brdf_suite/reflectance/live/shader.py": _CHILD,
    "brdf_suite/testing.py": "examples, in a folder of its own",
    "brdf_suite/acquisition/simulator/folder.py": "photographs that it makes, in an empty folder",
    "brdf_suite/appearance/colour/spectra.py": _SHIPPED,
    "brdf_suite/cli/default_action.py": _CHILD,
    "brdf_suite/cli/main.py": "the null device, in the place of an output that is closed",
    "brdf_suite/cli/streams.py": _OWN_COPY,
    "brdf_suite/cli/tools/bench.py": "benchmarks of a source checkout",
    "brdf_suite/cli/tools/listing.py": _SHIPPED,
    "brdf_suite/cli/tools/manual.py": _CHILD,
    "brdf_suite/cli/tools/measurements.py": "figures of a source checkout, and the kernel's of the processor",
    "brdf_suite/documents/atomic.py": "the function for writing",
    "brdf_suite/documents/factor_textures.py": _OWN_COPY,
    "brdf_suite/documents/project.py": "archives that are open, and parts of them",
    "brdf_suite/files/images/pictures.py": "the function for pictures",
    "brdf_suite/files/measured/merl.py": "a file that is open",
    "brdf_suite/files/meshes/reading.py": "trimesh takes a name; the file was checked",
    "brdf_suite/files/meshes/kinds.py": "an archive in memory",
    "brdf_suite/files/meshes/outside/assimp.py": "an archive whose file was checked",
    "brdf_suite/files/meshes/outside/child.py": _CHILD,
    "brdf_suite/files/meshes/outside/worker.py": "its answer, in a folder that its parent made",
    "brdf_suite/files/palettes/archive/zipped.py": "an archive in memory",
    "brdf_suite/library/pictures.py": _OWN_COPY,
    "brdf_suite/library/reference.py": _SHIPPED,
    "brdf_suite/lighting/filter/kernels/compilation.py": _CHILD,
    "brdf_suite/lighting/procedural/hosek_wilkie.py": _SHIPPED,
    "brdf_suite/output/video.py": "starts ffmpeg",
    "brdf_suite/palettes/swatches/look.py": _SHIPPED,
    "brdf_suite/pipeline/material.py": _SHIPPED,
    "brdf_suite/realtime/environment/look_up_table.py": _SHIPPED,
    "brdf_suite/realtime/gl/shader_source.py": _SHIPPED,
    "brdf_suite/reference/variant.py": _CHILD,
    "brdf_suite/reflectance/facet_albedo.py": _SHIPPED,
    "brdf_suite/regular_files.py": "the function for reading",
    "brdf_suite/reports/pdf_pen.py": "the font that sheet_text.py has found",
    "brdf_suite/reports/sheet_text.py": "fonts of the system, which Pillow finds by their names",
    "brdf_suite/screen.py": "asks whether there is an X server",
    "brdf_suite/acquisition/photographs/reading.py": "LibRaw takes a name; the file was checked",
    "brdf_suite/acquisition/photographs/tiff.py": "tifffile takes a name; the file was checked",
    "brdf_suite/acquisition/reconstruction/work_file.py": "the work file, to which records are appended",
    "brdf_suite/batches/worker.py": "begins a step of a batch, and no file",
    "brdf_suite/batches/workers.py": "workers of this machine, which inherit PYTHONSAFEPATH",
    "brdf_suite/cli/tools/shading_table.py": "an array in memory",
    "brdf_suite/files/cache/disk_cache.py": "the function for writing into a cache",
    "brdf_suite/files/images/exr/image.py": "OpenEXR takes a name; the file was checked",
    "brdf_suite/files/meshes/outside/values.py": "a copy, in a folder that its parent made",
    "brdf_suite/fitting/basis_search/search.py": "a pool, which inherits PYTHONSAFEPATH",
    "brdf_suite/palettes/swatches/process.py": "its own standard output",
    "brdf_suite/palettes/swatches/store.py": "the database of pictures, which SQLite opens",
    "brdf_suite/realtime/model_shader.py": "its own standard output",
    "brdf_suite/reference/state_file.py": "OpenEXR takes a name; the file was checked",
    "apps/brdf_color_swatch/panels/palette.py": "shows a dialog",
    "apps/brdf_lobe_visualizer/legend/control.py": "shows a dialog",
    "apps/brdf_qt/choosing/thumbnails.py": _SHIPPED,
    "apps/brdf_qt/program/run.py": "the picture of the window, for --screenshot",
    "apps/brdf_qt/program/translation.py": _SHIPPED,
    "apps/brdf_viewer/tracing/worker.py": "its own standard output",
}

# Words that are not used in docstrings, interface texts and documents. This file has to name them. The method
# ``tell()`` of Python's files has its name from Python.
_TELLING = r"told|(?<!file\.)(?<!stream\.)tell|tells|telling"
UNWANTED_WORDS = re.compile(rf"\b({_TELLING}|whoever|nobody|somebody|had back|gone on with)\b", re.IGNORECASE)
TELLING_WORDS = re.compile(rf"\b({_TELLING})\b", re.IGNORECASE)
REASON_FOR_LENGTH = re.compile(r"\blong because\b\s+(.+?)(?:\.\s|\.?$)", re.IGNORECASE | re.DOTALL)


Import = ast.Import | ast.ImportFrom


@dataclass(frozen=True)
class Breach:
    """A place that breaks a rule, and by how many units it does."""

    place: str
    reason: str
    amount: int = 1


@dataclass(frozen=True)
class Module:
    """One Python file of the checkout."""

    file: str  # relative to the checkout, with slashes
    name: str  # dotted, as it is imported; a package's ``__init__`` has the package's name
    text: str

    @cached_property
    def tree(self) -> ast.Module:
        """The parsed text."""
        return ast.parse(self.text, self.file)

    @cached_property
    def imports(self) -> list[tuple[Import, bool]]:
        """The import statements in the order of their lines, each with whether it stands inside a function."""
        found: list[tuple[Import, bool]] = []
        blocks: list[tuple[ast.AST, bool]] = [(self.tree, False)]
        while blocks:
            block, late = blocks.pop()
            late |= isinstance(block, ast.FunctionDef | ast.AsyncFunctionDef)
            for part in ("body", "orelse", "finalbody", "handlers", "cases"):
                inner = getattr(block, part, [])
                for node in inner if isinstance(inner, list) else []:
                    if isinstance(node, ast.Import | ast.ImportFrom):
                        found.append((node, late))
                    else:
                        blocks.append((node, late))
        return sorted(found, key=lambda item: item[0].lineno)

    @property
    def late_imports(self) -> list[Import]:
        """The import statements inside functions."""
        return [statement for statement, late in self.imports if late]

    @property
    def lines(self) -> int:
        """Number of lines."""
        return self.text.count("\n")

    @property
    def folder(self) -> str:
        """The folder that holds the file, relative to the checkout."""
        return self.file.rpartition("/")[0]

    @property
    def stem(self) -> str:
        """The file's name without its ending."""
        return Path(self.file).stem

    @property
    def is_package(self) -> bool:
        """Whether it is the ``__init__`` of a package."""
        return self.stem == "__init__"

    @property
    def room(self) -> str:
        """The top folder that it belongs to: a program, a room of the core, or a file beside the rooms."""
        return ".".join(self.name.split(".")[: 2 if self.name.startswith("brdf_suite") else 1])


class House:
    """The Python files and documents of a checkout."""

    def __init__(self, checkout: Path) -> None:
        self.checkout = checkout
        self.core = self._read("brdf_suite", checkout)
        self.apps = self._read("apps", checkout / "apps")
        self.tests = self._read("tests", checkout)
        self.tools = self._read("packaging", checkout) + self._read("tools", checkout)
        self.product = self.core + self.apps

    def _read(self, top: str, start: Path) -> list[Module]:
        modules = []
        for path in sorted((self.checkout / top).rglob("*.py")):
            name = ".".join(path.relative_to(start).with_suffix("").parts).removesuffix(".__init__")
            file = path.relative_to(self.checkout).as_posix()
            modules.append(Module(file, name, path.read_text(encoding="utf-8")))
        return modules

    @cached_property
    def documents(self) -> dict[str, str]:
        """The texts of the Markdown files by their paths."""
        paths = [*self.checkout.glob("*.md"), *(self.checkout / "docs").rglob("*.md")]
        return {
            path.relative_to(self.checkout).as_posix(): path.read_text(encoding="utf-8")
            for path in sorted(paths)
        }

    @cached_property
    def imports(self) -> dict[str, set[str]]:
        """Which modules of the product each module of it imports, at its top, for types or inside functions."""
        known = {module.name for module in self.product}
        return {
            module.name: {
                imported
                for statement, _ in module.imports
                for imported in names_imported(statement, known)
                if imported != module.name
            }
            for module in self.product
        }


def names_imported(statement: Import, known: set[str]) -> Iterator[str]:
    """The known modules that a statement imports; ``from package import module`` counts as the module."""
    if isinstance(statement, ast.Import):
        yield from (alias.name for alias in statement.names if alias.name in known)
        return
    base = statement.module or ""
    for alias in statement.names:
        if f"{base}.{alias.name}" in known:
            yield f"{base}.{alias.name}"
        elif base in known:
            yield base


def find_circles(graph: dict[str, set[str]]) -> list[list[str]]:
    """Sets of two or more nodes that reach each other (Tarjan 1972, without recursion), each sorted."""
    number: dict[str, int] = {}
    lowest: dict[str, int] = {}
    stack: list[str] = []
    on_stack: set[str] = set()
    circles = []
    for root in sorted(graph):
        work = [] if root in number else [(root, iter(sorted(graph[root])))]
        while work:
            node, successors = work[-1]
            if node not in number:
                number[node] = lowest[node] = len(number)
                stack.append(node)
                on_stack.add(node)
            for successor in successors:
                if successor not in number:
                    work.append((successor, iter(sorted(graph.get(successor, ())))))
                    break
                if successor in on_stack:
                    lowest[node] = min(lowest[node], number[successor])
            else:
                work.pop()
                if work:
                    lowest[work[-1][0]] = min(lowest[work[-1][0]], lowest[node])
                if lowest[node] == number[node]:
                    component = stack[stack.index(node) :]
                    del stack[stack.index(node) :]
                    on_stack.difference_update(component)
                    if len(component) > 1:
                        circles.append(sorted(component))
    return circles


def count_modules(modules: list[Module]) -> Counter[str]:
    """Modules by folder; the ``__init__`` of a package and the ``__main__`` of a program are none."""
    return Counter(module.folder for module in modules if module.stem not in ("__init__", "__main__"))


def count_names_passed(modules: list[Module]) -> dict[str, int]:
    """For each module, the sum over the folders on its path of the modules and sub-folders in them."""
    entries: dict[str, set[str]] = defaultdict(set)
    for module in modules:
        parts = module.file.split("/")
        for depth in range(1, len(parts)):
            if parts[depth] != "__init__.py":
                entries["/".join(parts[:depth])].add(parts[depth])
    passed = {}
    for module in modules:
        if not module.is_package:
            parts = module.file.split("/")
            passed[module.file] = sum(len(entries["/".join(parts[:depth])]) for depth in range(1, len(parts)))
    return passed


def find_class_names(modules: list[Module]) -> dict[str, list[Module]]:
    """The modules that define a public class at their top, by its name, in the order of the names."""
    found: dict[str, list[Module]] = defaultdict(list)
    for module in modules:
        for node in module.tree.body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                found[node.name].append(module)
    return dict(sorted(found.items()))


def find_shared_class_names(modules: list[Module]) -> dict[str, list[str]]:
    """Names of public classes that are defined in more than one room, with the rooms."""
    rooms = {name: {module.room for module in found} for name, found in find_class_names(modules).items()}
    return {name: sorted(found) for name, found in rooms.items() if len(found) > 1}


def find_private_accesses(modules: list[Module]) -> list[Breach]:
    """Attributes with one leading underscore that tests take of anything but themselves."""
    return [
        Breach(f"{module.file}:{node.lineno}", f"takes {node.attr}")
        for module in modules
        for node in ast.walk(module.tree)
        if isinstance(node, ast.Attribute)
        and re.match(r"_(?!_)", node.attr)
        and not (isinstance(node.value, ast.Name) and node.value.id in ("self", "cls"))
    ]


def find_long_files(modules: list[Module]) -> dict[str, str]:
    """Files over 500 lines with the reason that their docstring gives: "long because …"."""
    found = {}
    for module in modules:
        if module.lines > LONG_FILE:
            reason = REASON_FOR_LENGTH.search(ast.get_docstring(module.tree) or "")
            found[module.file] = " ".join(reason[1].split()) if reason else "no reason given"
    return found


def find_words(texts: dict[str, str], pattern: re.Pattern[str]) -> list[Breach]:
    """Every place in texts, by their files, where a word of the pattern stands."""
    return [
        Breach(f"{file}:{number}", f"has “{word[0]}”")
        for file, text in texts.items()
        for number, line in enumerate(text.splitlines(), 1)
        for word in pattern.finditer(line)
    ]


def check_folders(house: House) -> list[Breach]:
    """A folder holds at most 20 modules."""
    counts = count_modules(house.product + house.tests + house.tools)
    return [
        Breach(folder, f"holds {count} modules, at most {MODULES_IN_A_FOLDER}", count - MODULES_IN_A_FOLDER)
        for folder, count in sorted(counts.items())
        if count > MODULES_IN_A_FOLDER
    ]


def check_prefixes(house: House) -> list[Breach]:
    """At most three modules of a folder begin with the same word."""
    families: dict[tuple[str, str], list[str]] = defaultdict(list)
    for module in house.product:
        if not module.stem.startswith("_"):
            families[module.folder, module.stem.split("_")[0]].append(module.stem)
    return [
        Breach(f"{folder}/{prefix}_*", ", ".join(names), len(names) - SIBLINGS_WITH_ONE_PREFIX)
        for (folder, prefix), names in sorted(families.items())
        if len(names) > SIBLINGS_WITH_ONE_PREFIX
    ]


def check_circles(house: House) -> list[Breach]:
    """No modules import each other in a circle."""
    return [
        Breach(circle[0], "in a circle with " + ", ".join(circle[1:]))
        for circle in find_circles(house.imports)
    ]


def check_late_imports(house: House) -> list[Breach]:
    """Imports stand inside functions only in the command, in packages' ``__init__`` and for optional packages."""
    return [
        Breach(f"{module.file}:{statement.lineno}", ast.unparse(statement))
        for module in house.product
        if not module.is_package and module.room != "brdf_suite.cli" and module.file not in LATE_IMPORTS
        for statement in module.late_imports
        if not packages_imported(statement) <= OPTIONAL_PACKAGES
    ]


def packages_imported(statement: Import) -> set[str]:
    """The top packages that a statement imports from."""
    names = (
        [statement.module or ""]
        if isinstance(statement, ast.ImportFrom)
        else [a.name for a in statement.names]
    )
    return {name.split(".")[0] for name in names}


def check_class_names(house: House) -> list[Breach]:
    """At most 20 names of public classes are defined in more than one room."""
    found = [
        Breach(name, "defined in " + ", ".join(rooms))
        for name, rooms in find_shared_class_names(house.product).items()
    ]
    return found if len(found) > SHARED_CLASS_NAMES else []


def check_attributes_by_name(house: House) -> list[Breach]:
    """Parts of the programs do not ask each other for attributes by text."""
    found = []
    for module in house.apps:
        imported = {
            (alias.asname or alias.name).split(".")[0]
            for statement, _ in module.imports
            if isinstance(statement, ast.Import)
            for alias in statement.names
        }
        for node in ast.walk(module.tree):
            match node:
                case ast.Call(
                    func=ast.Name(id="getattr" | "hasattr"), args=[asked, ast.Constant(value=str(name)), *_]
                ):
                    if not (isinstance(asked, ast.Name) and asked.id in imported):
                        found.append(Breach(f"{module.file}:{node.lineno}", f"asks for “{name}” by text"))
    return found


_TREES = ("xml.etree.ElementTree", "lxml.etree", "defusedxml.ElementTree", "xml.dom.minidom", "xml.sax")
# Functions, of which a mention is enough: as an argument or under another name they are called elsewhere.
_FUNCTIONS = {
    *("open", "io.open", "io.open_code", "os.open", "os.fdopen", "os.popen", "os.system", "os.startfile"),
    *("os.fork", "os.forkpty", "os.posix_spawn", "os.posix_spawnp", "pty.spawn"),
    *(
        f"os.{kind}{how}"
        for kind in ("exec", "spawn")
        for how in ("l", "le", "lp", "lpe", "v", "ve", "vp", "vpe")
    ),
    *(f"subprocess.{name}" for name in ("run", "call", "check_call", "check_output", "getoutput")),
    *("subprocess.getstatusoutput", "asyncio.create_subprocess_exec", "asyncio.create_subprocess_shell"),
    *(f"numpy.{name}" for name in ("load", "save", "savez", "savez_compressed", "fromfile", "memmap")),
    *(f"numpy.{name}" for name in ("loadtxt", "savetxt", "genfromtxt")),
    *(
        "mmap.mmap",
        "sqlite3.connect",
        "PIL.Image.open",
        "OpenEXR.File",
        "OpenEXR.InputFile",
        "OpenEXR.OutputFile",
    ),
    *("rawpy.imread", "tifffile.imread", "tifffile.imwrite", "tifffile.memmap"),
    *("shutil.copy", "shutil.copy2", "shutil.copyfile", "shutil.copytree", "shutil.move"),
    *("gzip.open", "bz2.open", "lzma.open", "tarfile.open", "fileinput.input", "codecs.open"),
    *("tempfile.mkstemp", "tempfile.NamedTemporaryFile", "tempfile.TemporaryFile", "runpy.run_path"),
    *("socket.socketpair", "socket.create_connection", "socket.create_server", "urllib.request.urlopen"),
    *("QProcess.startDetached", "QFontDatabase.addApplicationFont"),
    *("PIL.ImageFont.truetype", "PIL.ImageCms.getOpenProfile", "cv2.imread", "cv2.imwrite", "mi.load_file"),
    *(f"trimesh.{name}" for name in ("load", "load_mesh", "load_path", "load_scene")),
    *(f"{package}.{name}" for package in _TREES for name in ("parse", "iterparse")),
    *("filecmp.cmp", "filecmp.cmpfiles", "ctypes.util.find_library", "mitsuba.load_file"),
    *("shutil.make_archive", "shutil.unpack_archive"),
}
_LAST_NAMES = {name.rpartition(".")[2] for name in _FUNCTIONS}
# Classes, of which an object must be made: their names stand in annotations, too.
_CLASSES = {
    *(
        "subprocess.Popen",
        "socket.socket",
        "ctypes.CDLL",
        "ctypes.WinDLL",
        "zipfile.ZipFile",
        "tarfile.TarFile",
    ),
    *(
        "tifffile.TiffFile",
        "tifffile.TiffWriter",
        "gzip.GzipFile",
        "bz2.BZ2File",
        "lzma.LZMAFile",
        "io.FileIO",
    ),
    *("multiprocessing.Process", "multiprocessing.Pool", "concurrent.futures.ProcessPoolExecutor"),
    *("distributed.LocalCluster", "distributed.SSHCluster", "distributed.SubprocessCluster"),
    *("http.client.HTTPConnection", "http.client.HTTPSConnection", "socketserver.TCPServer"),
    *("http.server.HTTPServer", "http.server.ThreadingHTTPServer", "logging.FileHandler"),
    *("configparser.ConfigParser", "configparser.RawConfigParser", "reportlab.pdfbase.ttfonts.TTFont"),
    *("cv2.VideoCapture", "cv2.VideoWriter"),
    *("QProcess", "QLocalServer", "QLocalSocket", "QTcpServer", "QTcpSocket", "QUdpSocket", "QWebSocket"),
    *(
        "QNetworkAccessManager",
        "QFile",
        "QSaveFile",
        "QTemporaryFile",
        "QImageReader",
        "QImageWriter",
        "QMovie",
    ),
}
_PICTURES = {"QImage", "QPixmap", "QIcon", "QBitmap", "QPicture"}
"""Classes of Qt that read a file where they are made of its name, and no file where of a size or of pixels."""
_OF_A_PATH = {"read_bytes", "read_text", "write_bytes", "write_text", "tofile"}


def imported_as(tree: ast.Module) -> dict[str, str]:
    """What each name of a module's imports stands for, dotted: ``o`` for ``os.open``."""
    names = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            # ``import a.b`` binds ``a``.
            names.update({a.asname: a.name for a in node.names if a.asname})
        elif isinstance(node, ast.ImportFrom):
            names.update({a.asname or a.name: f"{node.module}.{a.name}" for a in node.names})
    return names


def full_name(node: ast.expr, imported: dict[str, str]) -> str:
    """Return the dotted name of an expression as the module that defines it has it; Qt's without its package."""
    name = ast.unparse(node)
    first, dot, rest = name.partition(".")
    name = imported.get(first, first) + dot + rest
    return re.sub(r"^PySide6\.\w+\.", "", name.removeprefix("builtins."))


def is_path_like(node: ast.expr | None) -> bool:
    """Whether an argument is the name of a file by what is written: a text, a text made of a path, a name for one."""
    match node:
        case ast.JoinedStr() | ast.Constant(value=str()):
            return True
        case ast.Call(func=ast.Name(id="str" | "fspath" | "resource") | ast.Attribute(attr="fspath")):
            return True
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return re.search("path|file", name) is not None
    return False


def is_direct_call(call: ast.Call, name: str) -> bool:
    """Whether a call opens a file by a method or a class that does other things, too."""
    method = call.func.attr if isinstance(call.func, ast.Attribute) else ""
    first = call.args[0] if call.args else None
    keywords = {keyword.arg for keyword in call.keywords}
    if method == "open":
        mode = isinstance(first, ast.Constant) and re.fullmatch(r"[rwxa][bt+]*", str(first.value))
        # Without arguments, a path is opened, or what a class has of that name.
        bare = first is None and not name.startswith("self.")
        return bool(mode) or bare or "mode" in keywords
    if method in ("Process", "Pool") and "get_context(" in name:
        return True
    if method in ("load", "save"):  # our own take paths, and Qt's take texts
        return isinstance(first, ast.Call) and is_path_like(first) and ast.unparse(first.func) != "resource"
    return name in _CLASSES or method in _OF_A_PATH or (name in _PICTURES and is_path_like(first))


def find_direct_accesses(modules: list[Module]) -> list[Breach]:
    """Calls that open files, start processes or open sockets, but for the functions that the suite has for it."""
    found = []
    for module in modules:
        imported = imported_as(module.tree)
        for node in ast.walk(module.tree):
            if isinstance(node, ast.Call):
                name = full_name(node.func, imported)
                if not name.startswith("temporary.") and is_direct_call(node, name):  # what replacing() gives
                    found.append(Breach(f"{module.file}:{node.lineno}", f"calls {ast.unparse(node.func)}"))
            elif isinstance(node, ast.Attribute) or (
                isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)
            ):
                last = node.attr if isinstance(node, ast.Attribute) else imported.get(node.id, node.id)
                if last.rpartition(".")[2] in _LAST_NAMES and full_name(node, imported) in _FUNCTIONS:
                    found.append(Breach(f"{module.file}:{node.lineno}", f"calls {ast.unparse(node)}"))
    return found


def check_direct_accesses(house: House) -> list[Breach]:
    """Files are opened, and processes and sockets made, by the functions for it."""
    found = find_direct_accesses(house.product)
    return [breach for breach in found if breach.place.rpartition(":")[0] not in DIRECT_ACCESS]


def check_private_accesses(house: House) -> list[Breach]:
    """Tests use what is public, with at most 60 exceptions."""
    found = find_private_accesses(house.tests)
    return found if len(found) > PRIVATE_ACCESSES_IN_TESTS else []


def check_words(house: House) -> list[Breach]:
    """Texts are plain English."""
    modules = house.product + house.tests + house.tools
    texts = {module.file: module.text for module in modules if module.name != "tools.house"}
    return find_words(texts | house.documents, UNWANTED_WORDS)


RULES: dict[str, Callable[[House], list[Breach]]] = {
    "full folders": check_folders,
    "families of names": check_prefixes,
    "import circles": check_circles,
    "imports inside functions": check_late_imports,
    "class names in several rooms": check_class_names,
    "attributes by text": check_attributes_by_name,
    "private accesses in tests": check_private_accesses,
    "direct access": check_direct_accesses,
    "unwanted words": check_words,
}


def measure(house: House) -> dict[str, object]:
    """The structural figures, as they are printed."""
    folder, modules = max(count_modules(house.product).items(), key=lambda item: item[1])
    passed = count_names_passed(house.product)
    longest = max(passed, key=lambda file: passed[file])
    texts = {module.file: module.text for module in house.product}
    pipeline = [module for module in house.core if module.room == "brdf_suite.pipeline"]
    return {
        "largest_folder": folder,
        "largest_folder_modules": modules,
        "pipeline_modules": sum(not module.is_package for module in pipeline),
        "pipeline_lines": sum(module.lines for module in pipeline),
        "product_modules": len(house.product),
        "product_lines": sum(module.lines for module in house.product),
        "imports_inside_functions": sum(len(module.late_imports) for module in house.product),
        "import_circles": len(find_circles(house.imports)),
        "names_passed_mean": round(sum(passed.values()) / len(passed), 1),
        "names_passed_largest": passed[longest],
        "names_passed_largest_to": longest,
        "class_names_in_several_rooms": len(find_shared_class_names(house.product)),
        "class_names_in_several_modules": sum(
            len(found) > 1 for found in find_class_names(house.product).values()
        ),
        "private_accesses_in_tests": len(find_private_accesses(house.tests)),
        "told_tell_tells_telling": len(find_words(texts | house.documents, TELLING_WORDS)),
        "files_over_500_lines": find_long_files(house.product),
    }


def check(house: House, allowed: dict[str, int]) -> list[str]:
    """Lines that name what breaks a rule more often than is allowed; none where every rule is kept."""
    lines = []
    for rule, find in RULES.items():
        breaches = find(house)
        amount, limit = sum(breach.amount for breach in breaches), allowed.get(rule, 0)
        if amount > limit:
            lines.append(f"{rule}: {amount}, allowed {limit}. {find.__doc__}")
            lines += [f"  {breach.place}: {breach.reason}" for breach in breaches]
        elif amount < limit:
            print(f"{rule}: {amount}, allowed {limit}; lower the number in ALLOWED")
    return lines


def main(arguments: list[str] | None = None) -> int:
    """Print the figures, or check the rules."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0] if __doc__ else None)
    parser.add_argument("--json", action="store_true", help="print the figures as JSON")
    parser.add_argument(
        "--check", action="store_true", help="name what breaks a rule; status 1 where anything does"
    )
    parser.add_argument("--checkout", type=Path, default=Path(__file__).resolve().parents[1], metavar="DIR")
    options = parser.parse_args(arguments)
    house = House(options.checkout.resolve())
    if options.check:
        complaints = check(house, ALLOWED)
        print(*complaints, sep="\n") if complaints else print("Every rule is kept.")
        return 1 if complaints else 0
    figures = measure(house)
    if options.json:
        print(json.dumps(figures, indent=1, ensure_ascii=False))
    else:
        for name, value in figures.items():
            print(f"{name.replace('_', ' ')}: {value}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
