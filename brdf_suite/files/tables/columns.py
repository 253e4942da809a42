"""What the columns of a table are, by their headings: one table of names for palettes and for instruments' exports.

Headings are compared without case, stars, degree signs and marks between words. A heading may name an angle in any
usual way (``L15``, ``L*-15``, ``15° L*``, ``45as15 L``, ``r45as-15``, ``L* as15°``), a light and an observer
(``D65/10``), a wavelength (``400``, ``R400 nm``) or a difference (``dL``, ``ΔE``), which is passed over. The aspecular
angles, their ``45as15`` notation and the quantities of sparkle and graininess are those of the instruments' public
descriptions; the headings of their exports are not published, so a heading is known by what it says and never by its
place.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

Geometry = tuple[float, float, float]
"""Light, aspecular angle and azimuth, degrees."""

USUAL_LIGHT_DEG = 45.0

TEXTS: dict[str, str] = {
    word: what
    for what, words in {
        "name": "name colorname colourname samplename sample swatch swatchname title label bezeichnung farbname farbton"
        " probe probenname nome nom nombre paint paintname standard standardname trialname specimen 名称 样品名称 名前",
        "code": "code number no nr id ref reference identifier sampleid articleno artikelnummer"
        " samplenumber 样品编号",
        "group": "group family category folder collection gruppe kategorie",
        "notes": "notes note comment comments description remark remarks bemerkung kommentar 备注",
        "date": "date measured measurementdate datum timestamp datetime dateandtime measuredon 测量日期",
        "geometry": "angle geometry winkel geometrie aspecular aspecularangle measuringangle measurementangle"
        " messwinkel angolo angulo gonio 角度",
        "light": "illuminationangle lightangle incidence incidenceangle einfallswinkel",
        "azimuth": "azimuth azimuthangle azimut",
        "illuminant": "illuminant lichtart lightsource illuminantobserver lichtartbeobachter",
        "observer": "observer observerdeg beobachter standardobserver",
        "index": "measurement measurementno measurementnumber reading readingno messung messungnr repeat repetition",
        "type": "type typ recordtype sampletype datatype",
        "instrument": "instrument instrumentname device gerät model instrumentmodel 测试设备",
        "hex": "hex hexcode hexvalue html htmlcode web webcolor rgbhex css hexadecimal srgbhex colorhex hexrgb hexcolor"
        " hexcolour hextriplet hextripel hexcolorcode hexcolourcode htmlhex webhex csscolor csscolour hexadezimal rgba"
        " argb rgbahex argbhex hexrgba hexargb rrggbbaa aarrggbb #",
        "colour": "color colour farbe colore couleur value colorcode colourcode farbcode",
    }.items()
    for word in words.split()
}
"""Headings of one word (without spaces) and what they are; ``colour`` is a name or a hex code by what is in it."""

EFFECTS: dict[str, str] = {
    word: what
    for what, words in {
        "sparkle intensity": "si sparkleintensity sparklei glitzerintensität",
        "sparkle area": "sa sparklearea sparklea",
        "sparkle grade": "sg sparklegrade sparkle sparkling sparklevalue",
        "graininess": "graininess grain gdiff diffusegraininess körnigkeit graininessdiffuse hg",
        "coarseness": "coarseness diffusecoarseness dc coarse",
    }.items()
    for word in words.split()
}
GLOSS = ("gloss", "gu", "glanz", "g")

_WORDS = {
    "red": "r", "green": "g", "blue": "b", "rot": "r", "grün": "g", "blau": "b", "cyan": "c", "magenta": "m",
    "yellow": "y", "gelb": "y", "black": "k", "key": "k", "schwarz": "k", "lightness": "l", "luminance": "l",
    "chroma": "c", "hue": "h", "saturation": "s", "brightness": "v", "luminosity": "l", "hueangle": "h",
    "rouge": "r", "vert": "g", "bleu": "b", "jaune": "y", "noir": "k", "rosso": "r", "verde": "g", "blu": "b",
    "giallo": "y", "nero": "k", "rojo": "r", "azul": "b", "amarillo": "y", "negro": "k", "vermelho": "r",
    "amarelo": "y", "preto": "k", "cian": "c", "ciano": "c",
    "ciel": "l", "ciea": "a", "cieb": "b", "ciec": "c", "cieh": "h", "ciex": "x", "ciey": "y", "ciez": "z",
}  # fmt: skip
_FAMILIES = {
    "CMYK": "cmyk", "RGB": "rgb", "Lab": "lab", "LCh": "lch", "XYZ": "xyz", "HSL": "hsl", "HSB": "hsb", "CMY": "cmy",
}  # fmt: skip
_LETTERS = set("cmykrgblahxyzsv")
WHOLE = {
    "rgb": "RGB", "srgb": "RGB", "rgb255": "RGB", "cmyk": "CMYK", "lab": "Lab", "cielab": "Lab", "hsl": "HSL",
    "hsv": "HSB", "hsb": "HSB", "xyz": "XYZ", "ciexyz": "XYZ", "lch": "LCh", "cielch": "LCh",
}  # fmt: skip
"""Headings of columns with all numbers of a colour in one cell."""

_AS = re.compile(
    r"(?<![^\W_])(?:r?(\d{1,2}(?:\.\d+)?)\s*)?as\s*(minus|[-_])?\s*(\d{1,3}(?:\.\d+)?)"
    r"(?:\s*az(?:imuth)?\s*(minus|[-_])?\s*(\d{1,3}(?:\.\d+)?))?°?",
    re.IGNORECASE,
)
_WHITE = re.compile(
    r"[(\[]?\b(D50|D55|D65|D75|F2|F7|F11|A|C)\s*[/_ -]\s*(2|10)\b\s*(?:°|deg)?[)\]]?|[(\[]?\b(D50|D65)\b[)\]]?"
)
_DEGREES = re.compile(r"(?:(?<=[\s(\[_])|^)([-–]?\d{1,3}(?:\.\d+)?)\s*(?:°|deg\b)")
_WORD_FIRST = re.compile(
    r"(?P<word>[^\W\d_][^\d]*?)?[\s_@(\[:./]*(?P<minus>[-–])?\s*(?P<number>\d{1,4}(?:\.\d+)?)\s*(?P<unit>°|deg|nm)?[)\]\s]*"
)
_NUMBER_FIRST = re.compile(
    r"(?P<minus>[-–])?(?P<number>\d{1,4}(?:\.\d+)?)\s*(?P<unit>°|deg|nm)?[\s_:./)\]-]*(?P<word>[^\W\d_][^\d]*)"
)
_DIFFERENCE = re.compile(
    r"(?:d|δ|∆|delta)(?:l|a|b|c|h|e|ecmc|e00|e94|ecmc|edin99?|x|y|z|si|sa|sg|g|s)?(?:ab|cmc|00|p|94)?"
)
_SPECTRAL = (
    "",
    "r",
    "refl",
    "reflectance",
    "spectral",
    "nm",
    "spec",
    "sd",
    "lambda",
    "wl",
    "λ",
    "wavelength",
    "rnm",
)
_DATA = re.compile(r"[-+]?\d*[.,]\d+(?:[eE][-+]?\d+)?")
_STATISTICS: dict[str, str] = {
    word: what
    for what, words in {
        "deviation": "delta deltas δ δe diff difference differences differenz differenzen abweichung abweichungen"
        " tolerance tolerances toleranz toleranzen limit limits grenze grenzen grenzwert grenzwerte sd sigma dev"
        " deviation deviations stddev stdev standarddeviation standardabweichung stabw variance varianz spread range",
        "mean": "mean means average averages avg mittelwert mittelwerte durchschnitt",
        "extreme": "min max minimum maximum statistic statistics statistik",
        "beside": "upper lower plus minus positive negative pos neg obere oberer untere unterer oben unten std standard"
        " value values wert werte of e lab cielab reading readings measurement measurements data list set",
    }.items()
    for word in words.split()
}
"""Words of which the names of differences, tolerances and statistics are made, and what they are."""
_FORMULA = re.compile(r"(?:\b|[dDΔδ])[eE][\W_]*(?:76|94|00|1976|1994|2000)(?!\d)")
_LONGEST_HEADING = 80
_LEAST_BANDS = 3


@dataclass(frozen=True)
class TableColumn:
    """What one column is.

    ``what`` is a word of :data:`TEXTS`, a kind of :data:`EFFECTS`, ``gloss 20``, ``gloss 60``, ``spectrum``,
    ``difference``, ``derived``, a model and its channel (``Lab.a``), a whole model (``RGB``), or empty where it is not
    known. ``nm`` is the wavelength of a band; ``percent`` whether the heading has a percent sign; ``white`` its
    illuminant and observer, degrees, where it names them.
    """

    heading: str
    what: str = ""
    geometry: Geometry | None = None
    nm: float = 0.0
    percent: bool = False
    white: tuple[str, int] = ("", 0)


@dataclass(frozen=True)
class _Heading:
    column: TableColumn
    word: str
    hyphen: bool = False  # before the angle: a minus, or only a mark between word and angle


def interpret(headings: Sequence[str]) -> tuple[TableColumn, ...]:
    """Return what each column of a header is."""
    found = [_parse(heading) for heading in headings]
    found = _settle_hyphens(found)
    words = {heading.word for heading in found}
    if {"h", "s"} <= words:  # beside hue and saturation a value is one
        found = [_Heading(replace(one.column, what=""), "v") if one.word == "value" else one for one in found]
    columns = [heading.column for heading in found]
    bands = [i for i, column in enumerate(columns) if column.nm]
    if len({columns[i].nm for i in bands}) < _LEAST_BANDS:
        for i in bands:
            columns[i] = replace(columns[i], what="", nm=0.0)
    _assign_channels(columns, [heading.word for heading in found])
    return tuple(columns)


def parse_geometry(text: str, light_deg: float = USUAL_LIGHT_DEG) -> Geometry | None:
    """Return the geometry that a cell names, as in ``45as15``, ``-15°`` or ``25``; None where it names none.

    >>> parse_geometry("r45as-15")
    (45.0, -15.0, 0.0)
    """
    plain = text.replace("\u2212", "-").strip()
    if found := _AS.fullmatch(plain):
        return _geometry(found)
    bare = re.fullmatch(r"(?:as\s*)?([-+]?\d{1,3}(?:[.,]\d+)?)\s*(?:°|deg\.?|grad)?", plain, re.IGNORECASE)
    if bare is None:
        return None
    angle = float(bare[1].replace(",", "."))
    return (light_deg, angle, 0.0) if -90.0 < light_deg - angle < 90.0 else None


def _geometry(found: re.Match[str]) -> Geometry:
    light, minus, aspecular, turned, azimuth = found.groups()
    return (
        USUAL_LIGHT_DEG if light is None else float(light),
        -float(aspecular) if minus else float(aspecular),
        0.0 if azimuth is None else -float(azimuth) if turned else float(azimuth),
    )


def angle_text(geometry: Geometry | None) -> str:
    """Return an angle as it stands behind the name of a quantity, as in ``15°``; empty for none."""
    if geometry is None:
        return ""
    light, aspecular, _ = geometry
    return f" {aspecular:g}°" if light == USUAL_LIGHT_DEG else f" {light:g}as{aspecular:g}"


def plain_word(text: str) -> str:
    """Return a heading without case, spaces and marks."""
    return re.sub(r"[\W_]+", "", unicodedata.normalize("NFKC", text).casefold())


def is_statistic(text: str, *, means: bool = True) -> bool:
    """Return whether a name says no measurement: a difference, a tolerance or a deviation; with ``means`` a mean, too.

    Every word must belong to it, so that a paint may be called as one with another word, or with a number, as in
    ``SD-101``; only means may be numbered, as ``Average 2``, and differences have the year of their formula.

    >>> is_statistic("Tolerance +"), is_statistic("Delta Blue"), is_statistic("Mean value", means=False)
    (True, False, False)
    """
    plain = unicodedata.normalize("NFKC", text[:_LONGEST_HEADING]).replace("∆", "δ")
    words = re.findall(r"[^\W\d_]+", re.sub(r"(?<=[^\W\d_A-Z]{2})(?=[A-Z])", " ", plain).casefold())
    kinds = {_STATISTICS.get(word, "") for word in words}
    if any(map(str.isdecimal, _FORMULA.sub("", plain))):
        return means and {"mean"} <= kinds <= {"mean", "beside"}
    return "" not in kinds and ("deviation" in kinds or (means and bool(kinds & {"mean", "extreme"})))


@lru_cache(maxsize=1 << 14)
def _parse(heading: str) -> _Heading:
    if _DATA.fullmatch(heading):  # nearly all cells that are looked at for headings are data
        return _Heading(TableColumn(heading), "")
    text = unicodedata.normalize("NFKC", heading).replace("\u2212", "-").replace("*", "").strip()
    column = TableColumn(heading, percent="%" in text)
    if len(text) > _LONGEST_HEADING or not text:
        return _Heading(column, "")
    whole = "#" if text == "#" else plain_word(text)
    if whole in TEXTS:
        return _Heading(replace(column, what=TEXTS[whole]), whole)
    text = text.replace("%", " ")
    if (said := _WHITE.search(text)) and text[: said.start()].strip(" _-") + text[said.end() :].strip(" _-"):
        column = replace(column, white=(said[1] or said[3], int(said[2] or 0)))
        text = f"{text[: said.start()]} {text[said.end() :]}"
    if at := _AS.search(text):
        column = replace(column, geometry=_geometry(at))
        text = f"{text[: at.start()]} {text[at.end() :]}"
    elif (at := _DEGREES.search(text)) and abs(angle := float(at[1].replace("–", "-"))) <= 160.0:
        column = replace(column, geometry=(USUAL_LIGHT_DEG, angle, 0.0))
        text = f"{text[: at.start()]} {text[at.end() :]}"
    text = text.strip(" _/:.()[]").rstrip("-").strip()
    if column.geometry is not None:
        text = text.lstrip("- ")
    minus, number, unit, word = "", "", "", text
    found = _WORD_FIRST.fullmatch(text) or _NUMBER_FIRST.fullmatch(text)
    if found is not None and plain_word(text) not in WHOLE:
        parts = found.groupdict()
        minus, number, unit, word = (parts[key] or "" for key in ("minus", "number", "unit", "word"))
    key = plain_word(word)
    value = float(number) if number else 0.0
    if (
        key in GLOSS
        and not number
        and column.geometry is not None
        and column.geometry[1] in (20.0, 60.0, 85.0)
    ):
        return _Heading(replace(column, what=f"gloss {column.geometry[1]:.0f}", geometry=None), key)
    if number and key in GLOSS and value in (20.0, 60.0, 85.0) and column.geometry is None:
        return _Heading(replace(column, what=f"gloss {value:.0f}"), key)
    if number and 300.0 <= value <= 2500.0 and key in _SPECTRAL:
        return _Heading(replace(column, what="spectrum", nm=value), key)
    if number and column.geometry is None and value <= 160.0 and unit != "nm":
        column = replace(column, geometry=(USUAL_LIGHT_DEG, -value if minus else value, 0.0))
    elif number and value > 160.0:
        return _Heading(column, "")
    if _DIFFERENCE.fullmatch(key) and key not in EFFECTS and len(key) > 1:
        return _Heading(replace(column, what="difference"), "")
    if key in EFFECTS:
        return _Heading(replace(column, what=EFFECTS[key]), "")
    if key in WHOLE:
        return _Heading(replace(column, what=WHOLE[key]), "")
    return _Heading(column, _channel(key), hyphen=bool(minus))


def _channel(key: str) -> str:
    """Return the letter of a channel's heading, behind a letter for each family where the heading names one."""
    for unit in ("0255", "01", "0100", "value", "wert", "channel", "kanal"):
        key = key.removesuffix(unit) or key
    families = "cmyk srgb rgb cielab lab cielch lch xyz hsl hsv hsb colour color"
    for family in families.split():
        for rest in (key.removeprefix(family), key.removesuffix(family)):
            if rest != key and (rest in _LETTERS or rest in _WORDS):
                return _WORDS.get(rest, rest)
    return _WORDS.get(key, key if key in _LETTERS else "")


def _settle_hyphens(found: list[_Heading]) -> list[_Heading]:
    """Take a hyphen before the angles for a mark where every angle has one: ``L-15``, ``L-110``."""
    angles = [h for h in found if h.column.geometry and h.word and not _AS.search(h.column.heading)]
    marks = [h for h in angles if h.hyphen]
    if not marks or len(marks) < len(angles) or len({h.column.geometry for h in marks}) < 2:
        return found
    return [
        replace(h, column=replace(h.column, geometry=(USUAL_LIGHT_DEG, -h.column.geometry[1], 0.0)))
        if h.hyphen and h.column.geometry
        else h
        for h in found
    ]


def _assign_channels(columns: list[TableColumn], letters: Sequence[str]) -> None:
    """Give channels their model: neighbours of one angle and one light that make a model together."""
    whites: dict[Geometry | None, set[tuple[str, int]]] = {}
    groups: dict[tuple[Geometry | None, tuple[str, int]], list[int]] = {}
    channels = [i for i, column in enumerate(columns) if not column.what and letters[i] in _LETTERS]
    for index in channels:
        whites.setdefault(columns[index].geometry, set()).add(columns[index].white)
    for index in channels:
        # A light that one channel of an angle names is that of its neighbours.
        named = whites[columns[index].geometry] - {("", 0)}
        if len(named) == 1:
            columns[index] = replace(columns[index], white=next(iter(named)))
        groups.setdefault((columns[index].geometry, columns[index].white), []).append(index)
    for indices in groups.values():
        left = list(indices)
        for size in (4, 3):
            start = 0
            while start + size <= len(left):
                window = left[start : start + size]
                family = _family("".join(letters[i] for i in window))
                if family:
                    _take(columns, letters, window, family)
                    del left[start : start + size]
                else:
                    start += 1
        for family, parts in _FAMILIES.items():  # those that do not stand together
            window = [i for part in parts for i in left if letters[i] == part]
            if len(window) == len(parts) and _family("".join(letters[i] for i in window)):
                _take(columns, letters, window, family)
                left = [i for i in left if i not in window]
        taken = {columns[i].what.partition(".")[0] for i in indices}
        for i in left:
            if taken & {"Lab", "LCh", "XYZ", "spectrum"} and letters[i] in "lch":
                columns[i] = replace(columns[i], what="derived")
            elif letters[i] == "g" and not taken & {"RGB"}:
                columns[i] = replace(columns[i], what="graininess")
    for index, column in enumerate(columns):
        if not column.what and plain_word(column.heading) in ("gray", "grey", "grau"):
            columns[index] = replace(column, what="Gray.g")


def _family(letters: str) -> str:
    wanted = sorted(letters.replace("v", "b") if "v" in letters and "b" not in letters else letters)
    return next((name for name, parts in _FAMILIES.items() if sorted(parts) == wanted), "")


def _take(columns: list[TableColumn], letters: Sequence[str], window: Sequence[int], family: str) -> None:
    if family == "XYZ" and all(columns[i].heading in ("x", "y", "z") for i in window):
        return  # places in space, not tristimulus values
    for index in window:
        letter = "b" if letters[index] == "v" else letters[index]
        columns[index] = replace(columns[index], what=f"{family}.{letter}")
