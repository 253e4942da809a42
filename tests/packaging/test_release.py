"""What is published: metadata with and without an address, the page of others' work, the bill of materials."""

from __future__ import annotations

import importlib.util
import json
import re
import sys
import tomllib
from importlib.metadata import distribution
from pathlib import Path
from types import ModuleType

import pytest

import brdf_suite

ADDRESS = "https://example.org/owner/name"


@pytest.fixture
def script(checkout: Path, monkeypatch: pytest.MonkeyPatch):
    """Return a function that imports a script of ``packaging`` by its name."""
    monkeypatch.syspath_prepend(str(checkout / "packaging"))

    def load(name: str) -> ModuleType:
        spec = importlib.util.spec_from_file_location(name, checkout / "packaging" / f"{name}.py")
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        monkeypatch.setitem(sys.modules, name, module)
        spec.loader.exec_module(module)
        return module

    return load


def test_without_an_address_the_description_leads_nowhere_and_has_no_pictures(script, checkout: Path) -> None:
    text = script("project_metadata").description(
        (checkout / "README.md").read_text(encoding="utf-8"), "", "1.0"
    )
    assert text.startswith("# BRDF Suite")
    assert "![" not in text
    assert all(target.startswith("https://") for target in re.findall(r"\]\(([^)]*)\)", text))
    assert "colours at aspecular angles" in text  # a link's words stay
    assert "<!--" not in text


def test_with_an_address_every_link_and_picture_leads_to_a_file_of_the_release(
    script, checkout: Path
) -> None:
    metadata = script("project_metadata")
    text = metadata.description((checkout / "README.md").read_text(encoding="utf-8"), ADDRESS, "1.0")
    links = re.findall(r"(!?)\[[^\]]*\]\(([^)]*)\)", text)
    own = [(mark, target) for mark, target in links if target.startswith(ADDRESS)]
    assert len(own) > 10
    assert not [target for _, target in links if not target.startswith("https://")]
    for mark, target in own:
        kind, path = target.removeprefix(f"{ADDRESS}/").split("/v1.0/")
        assert kind == ("raw" if mark else "blob")
        assert (checkout / path.partition("#")[0]).exists(), path
    assert set(metadata.addresses(ADDRESS)) == {"Homepage", "Documentation", "Changelog", "Source", "Issues"}
    assert metadata.addresses("") == {}


def test_one_place_states_the_version_and_one_the_address(checkout: Path) -> None:
    settings = tomllib.loads((checkout / "pyproject.toml").read_text(encoding="utf-8"))
    assert {"version", "readme", "urls"} <= set(settings["project"]["dynamic"])
    assert settings["tool"]["hatch"]["metadata"]["hooks"]["custom"]["address"] == ""
    stated = [
        path
        for folder in ("brdf_suite", "apps")
        for path in (checkout / folder).rglob("*.py")
        if re.search(rf'= "{re.escape(brdf_suite.version)}"', path.read_text(encoding="utf-8"))
    ]
    assert [path.name for path in stated] == ["release.py"]
    assert distribution("brdf-suite").metadata["Keywords"]


def test_the_page_of_others_work_names_all_that_is_installed_with_the_suite(script, checkout: Path) -> None:
    packages = script("runtime_packages").runtime_packages()
    assert {"brdf-suite", "numpy", "pyside6-essentials", "mitsuba"} <= set(packages)
    assert not {"pytest", "twine", "mypy"} & set(packages)
    assert packages["mitsuba"].extra == "reference"
    assert packages["numpy"].extra == ""
    assert packages["tqdm"].licence == "MPL-2.0 AND MIT"
    page = (checkout / "THIRD_PARTY.md").read_text(encoding="utf-8")
    missing = [line for line in script("third_party").page().splitlines() if line not in page.splitlines()]
    assert missing == []
    assert "not stated" not in page


def test_the_licences_of_what_is_in_the_package_are_in_it(checkout: Path) -> None:
    settings = tomllib.loads((checkout / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    there = {path.relative_to(checkout).as_posix() for path in (checkout / "resources").rglob("LICENSE*")}
    assert there | {"LICENSE", "THIRD_PARTY.md"} == set(settings["license-files"])


def test_the_bill_of_materials_is_valid_and_says_what_needs_what(script) -> None:
    bill = json.loads(script("sbom").text())  # which refuses what the schema of CycloneDX does
    assert (bill["bomFormat"], bill["specVersion"]) == ("CycloneDX", "1.6")
    assert bill["metadata"]["component"]["name"] == "brdf-suite"
    components = {one["name"]: one for one in bill["components"]}
    assert components["numpy"]["scope"] == "required"
    assert components["mitsuba"]["scope"] == "optional"
    assert all(one["licenses"] and one["version"] for one in bill["components"])
    needs = {one["ref"]: one.get("dependsOn", []) for one in bill["dependencies"]}
    scipy = components["scipy"]["bom-ref"]
    assert components["numpy"]["bom-ref"] in needs[scipy]
    assert scipy in needs[bill["metadata"]["component"]["bom-ref"]]
