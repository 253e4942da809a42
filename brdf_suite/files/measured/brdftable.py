"""Our own tables and samples (.brdftable), read and written; see :mod:`brdf_suite.files.array_file` for the bytes.

The header is ``{"format": "brdftable", "version": 1, "kind", "source", "facts", ...}``. Kinds, with their arrays:

- ``isotropic``: ``values`` <f4 (θh, θd, φd, 3), ``holes`` |u1 (θh, θd, φd), 1 where not measured; header
  ``reciprocal``: φd over [0, π) or, if false, [0, 2π). Where it is known how well each bin is, also ``samples`` and
  ``deviation`` <f4 (θh, θd, φd): readings in a bin, and the standard error of its value over the value.
- ``anisotropic``: ``values`` <f4 (θi, φi, θo, φo, 3), ``theta_i`` and ``theta_o`` <f8, radians.
- ``factored``: ``p`` <f4 (n, n, 3) and ``q`` <f4 (m, m, 3), parabolic maps, and ``alpha`` <f8 (3,):
  f_r = alpha p(wo) q(h) p(wi).
- ``product``: the same with maps of any kind (n, 3) or (n, n, 3); header ``maps`` with ``logarithmic`` (of p and q),
  and ``more`` and ``peak``, lists of [name, projection, logarithmic] for the arrays ``more0`` …, ``peak0`` … <f4.
- ``scattered``: ``wi`` and ``wo`` <f8 (n, 3), ``values`` <f8 (n, 3), and where there are spectra
  ``spectra`` <f8 (n, k) and ``wavelengths_nm`` <f8 (k,); header ``isotropic``.

Values are f_r in 1/sr without the cosine, linear Rec. 2020 with D65 white.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from brdf_suite.arrays import AnyArray
from brdf_suite.errors import FileError, PathLike, ValueRangeError
from brdf_suite.files.array_file import Layout, read_arrays, write_arrays
from brdf_suite.files.measured.format import MeasuredFormat, tabulation_notes
from brdf_suite.reflectance.factored.map import MapFactor
from brdf_suite.reflectance.factored.model import MOST_MORE, Factored
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.anisotropic import AnisotropicTable
from brdf_suite.reflectance.tabulated.isotropic import Coverage, IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

NEEDED = {"p", "q", "alpha"}
OPTIONAL = {f"{part}{number}" for part in ("more", "peak") for number in range(MOST_MORE)}


def is_plain(value: Factored) -> bool:
    """Whether it is α p q p of two parabolic maps, interpolated as they are: what kind ``factored`` holds."""
    return not (value.logarithmic or value.more or value.peak or value.p.ndim == 2 or value.q.ndim == 2)


def product_parts(value: Factored) -> tuple[dict[str, Any], dict[str, AnyArray]]:
    """Return the header's own field ``maps``, and the arrays."""
    arrays: dict[str, AnyArray] = {"p": value.p, "q": value.q, "alpha": np.asarray(value.alpha, np.float64)}
    maps: dict[str, Any] = {"logarithmic": value.logarithmic}
    for part in ("more", "peak"):
        factors: tuple[MapFactor, ...] = getattr(value, part)
        maps[part] = [[factor.name, factor.projection, factor.logarithmic] for factor in factors]
        arrays |= {f"{part}{number}": factor.values for number, factor in enumerate(factors)}
    return {"maps": maps}, arrays


def product_value(header: Mapping[str, Any], arrays: Mapping[str, AnyArray]) -> Factored:
    """Return what :func:`product_parts` took apart; ``header`` holds ``maps``, ``source`` and ``facts``.

    Raises :class:`ValueRangeError`: ``maps`` is not as it should be, or an array is missing or is no map.
    """
    maps = header["maps"]
    if set(maps) != {"logarithmic", "more", "peak"} or not isinstance(maps["logarithmic"], bool):
        raise ValueRangeError("maps", 'expected "logarithmic", "more" and "peak" in the header')
    found = {part: _factors(part, maps[part], arrays) for part in ("more", "peak")}
    if len(arrays) != len(NEEDED) + sum(len(factors) for factors in found.values()):
        raise ValueRangeError("maps", "there are arrays that no factor reads")
    return Factored(
        arrays["p"],
        arrays["q"],
        arrays["alpha"],
        header["source"],
        header["facts"],
        more=found["more"],
        peak=found["peak"],
        logarithmic=maps["logarithmic"],
    )


def _factors(part: str, listed: object, arrays: Mapping[str, AnyArray]) -> tuple[MapFactor, ...]:
    if not isinstance(listed, list) or len(listed) > MOST_MORE:
        raise ValueRangeError("maps", f"{part}: expected a list of at most {MOST_MORE} factors")
    factors = []
    for number, item in enumerate(listed):
        key = f"{part}{number}"
        formed = isinstance(item, list) and [type(one) for one in item] == [str, str, bool]
        if not formed or len(item[0]) > 80 or key not in arrays:
            raise ValueRangeError(key, "expected a name, a projection and true or false, and the array")
        factors.append(MapFactor(item[1], arrays[key], item[2], item[0]))
    return tuple(factors)


VERSION = 1
LAYOUT = Layout(b"BRDFTABL", 0, ".brdftable file", ("<f4", "<f8", "|u1"), whole=True)

Table = IsotropicTable | AnisotropicTable | Factored | ScatteredSamples

#: kind -> arrays that must be there, header fields of its own, arrays that may be there
_KINDS: dict[str, tuple[set[str], dict[str, type], set[str]]] = {
    "isotropic": ({"values", "holes"}, {"reciprocal": bool}, {"samples", "deviation"}),
    "anisotropic": ({"values", "theta_i", "theta_o"}, {}, set()),
    "factored": ({"p", "q", "alpha"}, {}, set()),
    "product": (NEEDED, {"maps": dict}, OPTIONAL),
    "scattered": ({"wi", "wo", "values"}, {"isotropic": bool}, {"spectra", "wavelengths_nm"}),
}


def write_brdftable(value: Reflectance, path: PathLike) -> tuple[str, ...]:
    """Write a table, a product of maps or samples as they are; any other reflectance as 90 × 90 × 180 isotropic bins.

    Returns notes: what was lost, each a clause for the user.

    Raises :class:`FileError`: the file cannot be written, or the facts of the table are not plain values.
    """
    table: Table
    notes: tuple[str, ...] = ()
    if isinstance(value, (IsotropicTable, AnisotropicTable, Factored, ScatteredSamples)):
        table = value
    else:
        facts = dict(getattr(value, "facts", {}))
        notes = tabulation_notes(value)
        facts["notes"] = (*facts.get("notes", ()), *notes)
        table = IsotropicTable.from_reflectance(value, source=getattr(value, "source", ""), facts=facts)
    kind, own, arrays = _parts(table)
    header = {
        "format": "brdftable",
        "version": VERSION,
        "kind": kind,
        "source": table.source,
        "facts": _plain(table.facts),
        **own,
    }
    write_arrays(LAYOUT, path, header, arrays)
    return notes


def read_brdftable(path: PathLike) -> Table:
    """Return what :func:`write_brdftable` wrote.

    Raises
    ------
    FileError
        The file is missing, damaged, of a newer version, or holds what is no reflectance; the message says where.
    """
    header, arrays = read_arrays(LAYOUT, path)
    if header.pop("format", None) != "brdftable":
        raise FileError(path, 'expected the format "brdftable"', "header, format")
    version = header.pop("version", None)
    if version != VERSION:
        raise FileError(
            path, f"has version {str(version)[:20]}; this program reads {VERSION}", "header, version"
        )
    kind = header.pop("kind", None)
    if not isinstance(kind, str) or kind not in _KINDS:
        raise FileError(path, f"expected one of {', '.join(_KINDS)}", "header, kind")
    needed, own, optional = _KINDS[kind]
    if missing := needed - set(arrays):
        raise FileError(path, f"lacks the array {min(missing)!r}", "header, arrays")
    if unknown := set(arrays) - needed - optional:
        raise FileError(path, f"has an unknown array {min(unknown)[:40]!r}", "header, arrays")
    fields = {**own, "source": str, "facts": dict}
    for name, kind_of in fields.items():
        if not isinstance(header.get(name), kind_of):
            raise FileError(path, f"is missing or no {kind_of.__name__}", f"header, {name}")
    if unknown := set(header) - set(fields):
        raise FileError(path, "is unknown", f"header, {min(unknown)[:40]}")
    header["facts"] = {name: tuple(v) if isinstance(v, list) else v for name, v in header["facts"].items()}
    try:
        return _value(kind, header, arrays)
    except ValueRangeError as error:
        raise FileError(path, error.reason, f"array {error.place}") from error


def _parts(table: Table) -> tuple[str, dict[str, Any], dict[str, AnyArray]]:
    """Return kind, header fields of its own, and arrays."""
    if isinstance(table, IsotropicTable):
        holes = np.asarray(table.holes).view(np.uint8)
        own = {"reciprocal": table.reciprocal}
        arrays: dict[str, AnyArray] = {"values": table.values, "holes": holes}
        if table.coverage is not None:
            arrays |= {"samples": table.coverage.samples, "deviation": table.coverage.deviation}
        return "isotropic", own, arrays
    if isinstance(table, AnisotropicTable):
        arrays = {
            "values": table.values,
            "theta_i": table.theta_i,
            "theta_o": table.theta_o,
        }
        return "anisotropic", {}, arrays
    if isinstance(table, Factored):
        if not is_plain(table):
            return ("product", *product_parts(table))
        return "factored", {}, {"p": table.p, "q": table.q, "alpha": np.asarray(table.alpha, np.float64)}
    arrays = {"wi": table.wi, "wo": table.wo, "values": table.values}
    if table.spectra is not None and table.wavelengths_nm is not None:
        arrays |= {"spectra": table.spectra, "wavelengths_nm": table.wavelengths_nm}
    return "scattered", {"isotropic": table.isotropic}, arrays


def _value(kind: str, header: dict[str, Any], arrays: dict[str, AnyArray]) -> Table:
    for name, array in arrays.items():
        singles = {"values"} if kind != "scattered" else set()
        single = name in {"p", "q", *OPTIONAL, "samples", "deviation", *singles}
        wanted = "|u1" if name == "holes" else "<f4" if single else "<f8"
        if array.dtype.str != wanted:
            raise ValueRangeError(name, f"holds {array.dtype.str}; expected {wanted}")
    if kind == "isotropic":
        holes = arrays["holes"]
        if holes.max(initial=0) > 1:
            raise ValueRangeError("holes", "holds something else than 0 and 1")
        return IsotropicTable(
            arrays["values"], holes.view(np.bool_), coverage=_coverage(arrays, holes), **header
        )
    if kind == "anisotropic":
        return AnisotropicTable(arrays["values"], arrays["theta_i"], arrays["theta_o"], **header)
    if kind == "product":
        return product_value(header, arrays)
    if kind == "factored":
        return Factored(arrays["p"], arrays["q"], arrays["alpha"], **header)
    return ScatteredSamples(
        arrays["wi"],
        arrays["wo"],
        arrays["values"],
        arrays.get("spectra"),
        arrays.get("wavelengths_nm"),
        **header,
    )


def _coverage(arrays: dict[str, AnyArray], holes: AnyArray) -> Coverage | None:
    found = {name: arrays[name] for name in ("samples", "deviation") if name in arrays}
    if not found:
        return None
    if len(found) == 1:
        raise ValueRangeError(
            next(iter(found)), "samples and deviation belong together; one of them is missing"
        )
    coverage = Coverage(**found)
    if coverage.shape == holes.shape and np.any((coverage.samples > 0.0) & (holes != 0)):
        raise ValueRangeError("samples", "counts readings in a bin that holes says was not measured")
    return coverage


def _plain(value: Any) -> Any:
    """Return facts as JSON holds them; what it cannot hold is refused when it is written."""
    if isinstance(value, Mapping):
        return {str(name): _plain(item) for name, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    return value.item() if isinstance(value, np.generic) else value


FORMAT = MeasuredFormat(
    "brdftable",
    "BRDF Suite table",
    (".brdftable",),
    lambda head, _: head.startswith(LAYOUT.magic),
    lambda path, _: read_brdftable(path),
    write_brdftable,
)
