"""The set-up: what is missing is named, nothing is done twice, and a failure costs nothing that worked.

Real installations run in small projects without network access: their only package is a wheel in a folder.
"""

from __future__ import annotations

import ensurepip
import importlib
import os
import shlex
import shutil
import signal
import subprocess
import sys
import sysconfig
import time
import zipfile
from pathlib import Path
from types import ModuleType

import pytest

PROJECT = """
[build-system]
requires = []
build-backend = "backend"
backend-path = ["."]

[project]
name = "paint-project"
version = "1.0"
dependencies = ["pigment>=1"]

[project.optional-dependencies]
speed = []
flakes = ["mica; python_version >= '3'", "pearl; python_version < '3.4'"]
broken = ["no-such-package"]

[project.scripts]
brdf-suite = "pigment:main"
"""
BACKEND = """
import zipfile
def build_editable(folder, config_settings=None, metadata_directory=None):
    name, info = "paint_project-1.0-py3-none-any.whl", "paint_project-1.0.dist-info/"
    files = {
        "METADATA": "Metadata-Version: 2.1\\nName: paint-project\\nVersion: 1.0\\n",
        "WHEEL": "Wheel-Version: 1.0\\nGenerator: test\\nRoot-Is-Purelib: true\\nTag: py3-none-any\\n",
        "entry_points.txt": "[console_scripts]\\nbrdf-suite = pigment:main\\n",
    }
    files["RECORD"] = "".join(info + file + ",,\\n" for file in [*files, "RECORD"])
    with zipfile.ZipFile(folder + "/" + name, "w") as wheel:
        for file, text in files.items():
            wheel.writestr(info + file, text)
    return name
"""
# A build that never ends, in a process of its own that does not stop when asked to, and writes into the environment.
WRITE_FOREVER = '''
import signal, subprocess, sys

WRITER = """
import os, signal
signal.signal(signal.SIGTERM, signal.SIG_IGN)
signal.signal(signal.SIGINT, signal.SIG_IGN)
for number in range(10**6):
    os.makedirs(".venv/written", exist_ok=True)
    open(f".venv/written/{number % 1000}", "w").close()
    if number == 100:
        print("Collecting forever", flush=True)
"""

def build_editable(*arguments, **named):
    subprocess.run([sys.executable, "-c", WRITER])
'''
LOCK = "pigment==1.0\nmica==1.0\n"
UV = Path(sys.executable).with_name("uv")


def make_wheel(folder: Path, name: str, version: str = "1.0") -> None:
    """Write a pure Python package whose program prints its arguments."""
    folder.mkdir(exist_ok=True)
    info = f"{name}-{version}.dist-info"
    files = {
        f"{name}.py": "import sys\ndef main():\n    print(*sys.argv[1:])\n",
        f"{info}/METADATA": f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n",
        f"{info}/WHEEL": "Wheel-Version: 1.0\nGenerator: test\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
    }
    files[f"{info}/RECORD"] = "".join(f"{path},,\n" for path in [*files, f"{info}/RECORD"])
    with zipfile.ZipFile(folder / f"{name}-{version}-py3-none-any.whl", "w") as wheel:
        for path, text in files.items():
            wheel.writestr(path, text)


def write_project(root: Path) -> None:
    """Write the small project as it is before a test changes it."""
    (root / "packaging" / "lock.txt").write_text(LOCK)
    (root / "pyproject.toml").write_text(PROJECT)
    (root / "backend.py").write_text(BACKEND)
    shutil.rmtree(root.parent / "wheels", ignore_errors=True)
    for name in ("pigment", "mica"):
        make_wheel(root.parent / "wheels", name)


# Stands in for the module of system packages: those are no matter of these tests, and the machine may lack some.
SYSTEM = """
def install_system_libraries(for_tests):
    pass


def install_optional_libraries():
    pass
"""
# Stands in for ensurepip, which takes seconds to compile the same pip for each environment, and for the installation of
# uv from a network, where this environment has it.
COPY_TOOLS = """
import os, sysconfig, venv

def copy_tools(builder, context):
    packages = sysconfig.get_path("purelib", "venv", {{"base": context.env_dir}})
    for name in os.listdir({pip!r}):
        os.symlink(os.path.join({pip!r}, name), os.path.join(packages, name))
    if os.path.exists({uv!r}):
        os.symlink({uv!r}, os.path.join(context.bin_path, "uv"))

venv.EnvBuilder._setup_pip = copy_tools
"""


def make_project(checkout: Path, folder: Path, pip: Path | None = None, uv: Path | None = None) -> Path:
    """Copy the set-up into a small project, in a folder with a space and letters beyond ASCII.

    Environments get a copy of the packages in ``pip`` (``None``: what Python installs) and ``uv`` where it is there.
    """
    root = folder / "Lack für Götz"
    (root / "packaging").mkdir(parents=True)
    for name in ("installer.py", "prepare.py", "report.py", "run.py"):
        shutil.copy(checkout / "packaging" / name, root / "packaging")
    tools = {"pip": str(pip), "uv": str(uv or "")}
    stand_ins = SYSTEM if pip is None else SYSTEM + COPY_TOOLS.format(**tools)
    (root / "packaging" / "system_libraries.py").write_text(stand_ins)
    write_project(root)
    return root


@pytest.fixture
def project(checkout: Path, tmp_path: Path) -> Path:
    """Return a project without an environment."""
    return make_project(checkout, tmp_path)


@pytest.fixture(scope="session")
def pip(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the packages of a new environment: pip, from the wheel that Python brings where it brings one."""
    folder = tmp_path_factory.mktemp("pip")
    for wheel in (Path(ensurepip.__file__).parent / "_bundled").glob("pip-*.whl"):
        shutil.unpack_archive(wheel, folder, "zip")
        return folder
    subprocess.run([sys.executable, "-m", "venv", folder], check=True)
    return Path(sysconfig.get_path("purelib", "venv", {"base": str(folder)}))


@pytest.fixture(scope="module")
def shared_project(checkout: Path, tmp_path_factory: pytest.TempPathFactory, pip: Path) -> Path:
    """Share one project, since installing its package takes seconds; where uv is there, it installs."""
    return make_project(checkout, tmp_path_factory.mktemp("prepared"), pip, UV)


@pytest.fixture
def prepared(shared_project: Path) -> Path:
    """Return the project with its files as at first and its environment made from them."""
    write_project(shared_project)
    run(shared_project, "--prepare-only")
    return shared_project


def surroundings(project: Path) -> dict[str, str]:
    """Return environment variables with which pip and uv look into one folder only."""
    kept = {
        name: value for name, value in os.environ.items() if not name.startswith(("PIP_", "UV_", "PYTHON"))
    }
    wheels = str(project.parent / "wheels")
    only = {"PIP_NO_INDEX": "1", "UV_NO_INDEX": "1", "PIP_FIND_LINKS": wheels, "UV_FIND_LINKS": wheels}
    return {**kept, **only, "PIP_CONFIG_FILE": os.devnull, "UV_CACHE_DIR": str(project.parent / "uv cache")}


def run(
    project: Path, *arguments: str, check: bool = True, cwd: Path | None = None
) -> subprocess.CompletedProcess[str]:
    """Run the project's ``packaging/run.py`` as a user does."""
    done = subprocess.run(
        [sys.executable, str(project / "packaging" / "run.py"), *arguments],
        cwd=cwd,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
        env=surroundings(project),
    )
    if check:
        assert (done.returncode, done.stderr) == (0, ""), done.stdout + done.stderr
    return done


def installed(project: Path, package: str) -> str:
    """Return the version of a package in the project's environment, empty where it is missing.

    Its modules are not imported: bytecode of another version could pass for theirs, which were written in the same
    two seconds and have the same size.
    """
    code = (
        "import importlib.metadata as m, sys\n"
        "print(next((one.version for one in m.distributions(name=sys.argv[1])), ''))"
    )
    python = project / ".venv" / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    asked = [python, "-c", code, package]
    return subprocess.run(asked, capture_output=True, text=True, check=True).stdout.strip()


def test_first_run_installs_and_passes_the_arguments_on(project: Path) -> None:
    first = run(project, "render", "blue", "--size", "3x2")
    assert first.stdout.splitlines()[-1] == "render blue --size 3x2"
    assert "uv cannot be installed here; using pip" in first.stdout
    assert installed(project, "pigment") == "1.0"
    assert installed(project, "mica") == ""
    second = run(project, "render", "red")
    assert second.stdout == "render red\n"


def test_uv_installs_where_it_is_there(project: Path, checkout: Path) -> None:
    if not UV.exists():
        pytest.skip("uv is not installed beside this Python")
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", project / ".venv"], check=True)
    shutil.copy(UV, project / ".venv" / "bin")
    # Only the first fill of this environment is looked at: an unknown one would be made again without uv.
    code = (
        "import sys; from pathlib import Path; sys.path.insert(0, sys.argv[1])\n"
        "from installer import Installer\n"
        "root = Path(sys.argv[1]).parent; lock = root / 'packaging' / 'lock.txt'\n"
        "one = Installer(root / '.venv/bin/python', lock, root / '.venv/install.log', root)\n"
        "one.install('pigment'); one.install('--no-build-isolation', '--no-deps', '--editable', '.')\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(project / "packaging")],
        capture_output=True,
        text=True,
        check=False,
        env=surroundings(project),
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert "installed 1 package" in done.stdout
    assert "pip" not in done.stdout
    assert installed(project, "pigment") == "1.0"
    assert (project / ".venv" / "bin" / "brdf-suite").exists()


def test_extras_are_added_and_stay(prepared: Path) -> None:
    added = run(prepared, "--with", "flakes")
    assert added.stdout.splitlines()[-1] == "[brdf-suite] Ready, with flakes"
    assert "Making a Python environment" not in added.stdout
    version = ".".join(map(str, sys.version_info[:2]))
    assert f"pearl is not published for Python {version}; continuing without it" in added.stdout
    assert installed(prepared, "mica") == "1.0"
    assert run(prepared, "--with=flakes", "measure").stdout == "measure\n"  # nothing left to do
    make_wheel(prepared.parent / "wheels", "pigment", "1.1")
    (prepared / "packaging" / "lock.txt").write_text("pigment==1.1\nmica==1.0\n")
    run(prepared, "--prepare-only")
    assert installed(prepared, "pigment") == "1.1"
    assert installed(prepared, "mica") == "1.0"


def test_an_unknown_extra_lists_the_known_ones(prepared: Path) -> None:
    for words in (("--with", "chrome"), ("--with", "flakes,chrome", "render")):
        done = run(prepared, *words, check=False)
        assert done.returncode == 1
        assert done.stderr == "chrome: no such extra; there are broken, flakes, speed.\n"
    nothing = run(prepared, "--with", check=False)
    assert nothing.stderr == "--with: name extras, of broken, flakes, speed.\n"


def test_a_failed_renewal_keeps_the_former_environment(prepared: Path) -> None:
    lock = prepared / "packaging" / "lock.txt"
    lock.write_text("pigment==7.0\n")
    failed = run(prepared, "--prepare-only", check=False)
    assert failed.returncode == 1
    assert "could not be installed" in failed.stderr
    assert "pigment==7.0" in failed.stderr
    assert "pigment==7.0" in (prepared / ".venv" / "install.log").read_text()
    assert installed(prepared, "pigment") == "1.0"
    lock.write_text("pigment==1.0\nmica==1.0\n")
    assert run(prepared, "--prepare-only").stdout == "[brdf-suite] Ready\n"


def test_what_an_interrupted_renewal_left_behind_is_no_obstacle(prepared: Path) -> None:
    (prepared / ".venv.former" / "lib").mkdir(parents=True)
    (prepared / "packaging" / "lock.txt").write_text(f"{LOCK}# another\n")
    run(prepared, "--prepare-only")
    assert installed(prepared, "pigment") == "1.0"
    assert not (prepared / ".venv.former").exists()


def test_the_working_folder_is_not_imported_from(prepared: Path, tmp_path: Path) -> None:
    for name in ("compileall.py", "struct.py"):
        (tmp_path / name).write_text("open('was_run', 'w').close()\n")
    (prepared / "pyproject.toml").write_text(
        PROJECT.replace('version = "1.0"', 'version = "1.0"\nkeywords = ["new"]')
    )
    run(prepared, "--prepare-only", cwd=tmp_path)
    assert not (tmp_path / "was_run").exists()


def test_a_failed_extra_keeps_the_environment_usable(prepared: Path) -> None:
    failed = run(prepared, "--with", "broken", check=False)
    assert failed.returncode == 1
    assert "no-such-package" in failed.stderr
    assert "Traceback" not in failed.stderr
    assert run(prepared, "fit").stdout == "fit\n"


def test_a_new_version_of_the_project_needs_no_package(prepared: Path) -> None:
    """As after an update of the source without network access."""
    file = prepared / "pyproject.toml"
    file.write_text(file.read_text().replace('version = "1.0"', 'version = "1.0"\ndescription = "new"'))
    for wheel in (prepared.parent / "wheels").iterdir():
        wheel.unlink()
    said = run(prepared, "--prepare-only").stdout
    assert "Making a Python environment" not in said
    file.write_text(file.read_text() + "\n[tool.other]\nx = 1\n")
    assert run(prepared, "--prepare-only").stdout == "[brdf-suite] Ready\n"


def test_a_package_that_was_taken_away_is_put_back(prepared: Path) -> None:
    (path,) = (prepared / ".venv").glob("**/site-packages/pigment-1.0.dist-info")
    shutil.rmtree(path)
    said = run(prepared, "--prepare-only").stdout
    assert "The environment is damaged; making it again" in said
    assert installed(prepared, "pigment") == "1.0"


def test_an_unreadable_record_makes_the_environment_again(prepared: Path) -> None:
    (prepared / ".venv" / "brdf-suite-prepared").write_text('{"packages": "')
    (prepared / "packaging" / "lock.txt").write_text("pigment==7.0\n")
    failed = run(prepared, "--prepare-only", check=False)
    assert "Making a Python environment" in failed.stdout
    assert installed(prepared, "pigment") == "1.0"


def test_a_file_in_place_of_the_environment_is_replaced_only_by_a_whole_one(
    checkout: Path, tmp_path: Path, pip: Path
) -> None:
    project = make_project(checkout, tmp_path, pip)
    (project / ".venv").write_text("mine")
    (project / "packaging" / "lock.txt").write_text("pigment==7.0\n")
    assert run(project, "--prepare-only", check=False).returncode == 1
    assert (project / ".venv").read_text() == "mine"


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write anywhere")
def test_a_place_without_permission_is_named(project: Path) -> None:
    project.chmod(0o500)
    try:
        done = run(project, "--prepare-only", check=False)
    finally:
        project.chmod(0o700)
    assert done.returncode == 1
    assert "cannot be written" in done.stderr


@pytest.mark.skipif(sys.platform == "win32", reason="an interrupt is sent in another way there")
def test_an_interrupt_keeps_the_former_environment(prepared: Path) -> None:
    (prepared / "backend.py").write_text(WRITE_FOREVER)
    lock = prepared / "packaging" / "lock.txt"
    lock.write_text(lock.read_text() + "# another\n")
    with subprocess.Popen(
        [sys.executable, str(prepared / "packaging" / "run.py"), "--prepare-only"],
        env=surroundings(prepared),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as running:
        assert running.stdout is not None
        while "Installing packages" not in (line := running.stdout.readline()):
            assert line, "ended before it began"
        while not (prepared / ".venv" / "written" / "100").exists():
            assert running.poll() is None
            time.sleep(0.01)
        running.send_signal(signal.SIGINT)
        _, said = running.communicate(timeout=200)
    assert said == "cancelled; run this command again to continue\n"
    assert running.returncode == 130
    assert installed(prepared, "pigment") == "1.0"
    assert not list((prepared / ".venv").glob("written*"))


@pytest.fixture
def modules(checkout: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """Import the set-up's own modules as its programs do, and forget them afterwards."""
    monkeypatch.syspath_prepend(str(checkout / "packaging"))
    names = ("installer", "prepare", "report", "system_libraries")
    for name in names:
        monkeypatch.delitem(sys.modules, name, raising=False)
    module = importlib.import_module("prepare")
    for name in names:
        monkeypatch.setitem(sys.modules, name, importlib.import_module(name))
    return module


def test_a_library_that_cannot_be_loaded_names_its_package(modules: ModuleType, monkeypatch) -> None:
    libraries = sys.modules["system_libraries"]
    monkeypatch.setattr(libraries, "LIBRARIES", {"libno_such_thing.so.9": "libno-such-thing9"})
    assert "libno-such-thing9" in libraries.missing_packages(for_tests=False)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="system packages are a matter of Linux")
@pytest.mark.parametrize(
    ("has_apt", "words"), [(True, "sudo apt-get install -y"), (False, "package manager")]
)
def test_without_permission_the_command_to_run_is_printed(
    modules: ModuleType, monkeypatch, has_apt: bool, words: str
) -> None:
    libraries = sys.modules["system_libraries"]
    monkeypatch.setattr(libraries, "missing_packages", lambda for_tests: ["libegl1", "xvfb"])
    monkeypatch.setattr(libraries, "root_prefix", lambda: None)
    monkeypatch.setattr(libraries.shutil, "which", lambda name: f"/usr/bin/{name}" if has_apt else None)
    with pytest.raises(SystemExit, match=words) as stopped:
        libraries.install_system_libraries(for_tests=True)
    assert "libegl1" in str(stopped.value)
    assert "xvfb" in str(stopped.value)


def test_an_old_python_is_refused(modules: ModuleType, monkeypatch) -> None:
    monkeypatch.setattr(modules, "MINIMUM", (99, 0))
    with pytest.raises(SystemExit, match=r"needs Python 99\.0"):
        modules.prepare()


def test_output_of_pip_becomes_a_few_lines_and_a_log(modules: ModuleType, tmp_path: Path, capsys) -> None:
    pip = stand_in(
        tmp_path,
        "for i in range(44): print('WARNING: irrelevant')\n"
        "for i in range(23): print('Collecting package%d==1.0 (from brdf-suite)' % i)\n"
        "print('Installing collected packages: a, b, c')",
    )
    log = tmp_path / "install.log"
    sys.modules["installer"].Installer(pip, tmp_path / "lock.txt", log, tmp_path).install("numpy")
    lines = capsys.readouterr().out.splitlines()
    assert lines[-4:] == [
        "[brdf-suite] fetching package 1, package0==1.0",
        "[brdf-suite] fetching package 11, package10==1.0",
        "[brdf-suite] fetching package 21, package20==1.0",
        "[brdf-suite] installing 3 packages",
    ]
    assert log.read_text().count("Collecting package22") == 2  # uv was looked for first


def test_on_a_terminal_one_line_changes(modules: ModuleType, tmp_path: Path, monkeypatch, capsys) -> None:
    pip = stand_in(tmp_path, "for i in range(3): print('Collecting package%d' % i)")
    (tmp_path / "uv").write_bytes(pip.read_bytes())  # so that it is not looked for
    (tmp_path / "uv").chmod(0o755)
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    log = tmp_path / "install.log"
    sys.modules["installer"].Installer(pip, tmp_path / "lock.txt", log, tmp_path).install("numpy")
    out = capsys.readouterr().out
    assert "\n" not in out
    shown = [part.strip() for part in out.split("\r") if part.strip()]
    assert shown == [f"[brdf-suite] fetching package {i + 1}, package{i}" for i in range(3)]
    assert out.split("\r")[-2].strip() == ""  # and goes away at the end


def test_the_last_lines_of_a_failure_are_shown(modules: ModuleType, tmp_path: Path) -> None:
    pip = stand_in(
        tmp_path,
        "for i in range(40): print('line', i)\n"
        "print('ERROR: no such package')\nprint('WARNING: irrelevant')\nsys.exit(1)",
    )
    installer = sys.modules["installer"]
    with pytest.raises(installer.InstallError) as caught:
        installer.Installer(pip, tmp_path / "lock.txt", tmp_path / "log", tmp_path).install("numpy")
    text = str(caught.value)
    assert "ERROR: no such package" in text
    assert "WARNING" not in text
    assert "line 20" not in text
    assert "line 39" in text


def stand_in(folder: Path, body: str) -> Path:
    """Write a program that takes the place of Python and pip."""
    script, program = folder / "stand_in.py", folder / "python"
    script.write_text(f"import sys\n{body}\n")
    # The first line of a script cannot name an interpreter whose path has a space.
    program.write_text(f'#!/bin/sh\nexec {shlex.quote(sys.executable)} {shlex.quote(str(script))} "$@"\n')
    program.chmod(0o755)
    return program
