"""Write the bill of materials of a release as CycloneDX JSON: ``.venv/bin/python packaging/sbom.py [-o FILE]``.

It lists the suite and what a user installs with it and its extras, with versions, licences and what needs what.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from cyclonedx.contrib.license.factories import LicenseFactory
from cyclonedx.model import ExternalReference, ExternalReferenceType, XsUri
from cyclonedx.model.bom import Bom
from cyclonedx.model.component import Component, ComponentScope, ComponentType
from cyclonedx.output import make_outputter
from cyclonedx.schema import OutputFormat, SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator
from packageurl import PackageURL
from runtime_packages import PROJECT, Package, runtime_packages

SCHEMA = SchemaVersion.V1_6


def bill() -> Bom:
    """Return the bill of materials of what is installed here."""
    packages = runtime_packages()
    made = {name: _component(name, one) for name, one in packages.items()}
    bom = Bom(components=(one for name, one in made.items() if name != PROJECT))
    bom.metadata.component = made[PROJECT]
    for name, one in packages.items():
        bom.register_dependency(made[name], [made[need] for need in one.needs if need != name])
    return bom


def _component(name: str, one: Package) -> Component:
    url = PackageURL("pypi", name=name, version=one.found.version)
    licences = [LicenseFactory().make_from_string(one.licence)] if one.licence else []
    home = (
        [ExternalReference(type=ExternalReferenceType.WEBSITE, url=XsUri(one.address))] if one.address else []
    )
    return Component(
        type=ComponentType.APPLICATION if name == PROJECT else ComponentType.LIBRARY,
        name=one.name,
        version=one.found.version,
        bom_ref=str(url),
        purl=url,
        description=str(one.found.metadata.get("Summary") or ""),
        licenses=licences,
        external_references=home,
        scope=ComponentScope.OPTIONAL if one.extra else ComponentScope.REQUIRED,
    )


def text() -> str:
    """Return the bill as JSON that is valid by the schema of CycloneDX; raise :class:`ValueError` where it is not."""
    written = make_outputter(bill(), OutputFormat.JSON, SCHEMA).output_as_string(indent=2)
    wrong = JsonStrictValidator(SCHEMA).validate_str(written)
    if wrong is not None:
        raise ValueError(f"the bill of materials is not valid: {wrong}")
    return written + "\n"


def main() -> int:
    """Write the bill."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("-o", "--output", type=Path, help="the file (default: standard output)")
    options = parser.parse_args()
    if options.output is None:
        print(text(), end="")
    else:
        options.output.write_text(text(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
