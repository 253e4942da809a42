"""Print what a second family of lobes, ``((1 + R·V)/2)^E``, does to readings and pictures (docs/method/fit.md).

python tests/benchmarks/comparisons/compare_lobe_families.py

These lobes do not end at 90° as the cosines do. They are judged over the database twice: by the colours that an
instrument reads, and by spheres in environment light, once with every lobe integrated and once as the renderer looks
it up.
"""

from __future__ import annotations

import numpy as np
from lobe_experiment import COSINE, HELD_OUT, Database, Lobes, arguments, l1_program, paints, table

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.files.images.environments import read_environment_image
from brdf_suite.fitting import default_basis
from brdf_suite.fitting.lobes.program import ENERGY_WEIGHT
from brdf_suite.fitting.lobes.samples import CoatSamples
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.lighting.latlong import column_angles, direction, fejer_weights, ring_angles
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.protocol import Layered
from brdf_suite.resources import resource, resource_names

RULES = ("flake", "monotone")
#: Exponents below this form the flop; the others, for coats, are the same in every set.
BROAD_BELOW = 40.0
ROWS = 32  # of an environment: the base's lobes are 20° wide and more
NORMALS = 120
VIEW = np.array([0.0, 0.0, 1.0])
LUMINANCE = np.array([0.2627, 0.6780, 0.0593])
MIDDLE_GREY = 0.18


def sets() -> dict[str, Lobes]:
    """The sets that are compared, by name."""
    exponents = default_basis().exponents
    broad = tuple(e for e in exponents if e < BROAD_BELOW)
    sharp = exponents[len(broad) :]
    named = {"cosines alone (default)": Lobes(exponents)}
    for half in (1.0, 2.0, 2.5, 3.0):
        named[f"the broadest replaced by half {half:g}"] = Lobes(exponents[1:], (half,))
    named["half 2 added"] = Lobes(exponents, (2.0,))
    named["cosine 1 added"] = Lobes((1.0, *exponents))
    named["two replaced, by half 2 and 4"] = Lobes(exponents[2:], (2.0, 4.0))
    named["all broad ones replaced"] = Lobes(sharp, tuple(2.0 * e for e in broad))
    return named


def searched(databases: dict[str, Database], replaced: int, steps: int) -> Lobes:
    """Move the broad exponents for the least sum of equation 4 over both rules; ``replaced`` are half lobes."""
    from scipy.optimize import minimize

    exponents = default_basis().exponents
    broad = np.array([e for e in exponents if e < BROAD_BELOW])
    start = np.log(np.concatenate([broad[replaced:], 2.0 + 2.0 * np.arange(replaced)]))
    cosines = broad.size - replaced

    def lobes(x: Floats) -> Lobes:
        moved = np.exp(np.clip(x, 0.0, 4.0))  # a basis holds no exponent below 1
        return Lobes((*np.sort(moved[:cosines]), *exponents[broad.size :]), tuple(moved[cosines:]))

    simplex = np.vstack([start, start + 0.25 * np.eye(start.size)])
    found = minimize(
        lambda x: sum(d.errors(lobes(x)).equation_4 for d in databases.values()),
        start,
        method="Nelder-Mead",
        options={"maxfev": steps, "initial_simplex": simplex},
    )
    return lobes(found.x)


def readings(databases: dict[str, Database], steps: int) -> None:
    """Print both tables of readings."""
    header = ["lobes", *(f"{rule}: {what}" for rule in RULES for what in ("≤ 82°", "≥ 88°", "max + mean"))]
    rows = []
    named = sets()
    for replaced in range(3):
        lobes = searched(databases, replaced, steps)
        broad = ", ".join(f"{e:.2g}" for e in lobes.cosine if e < BROAD_BELOW)
        half = ", ".join(f"{e:.2g}" for e in lobes.half) or "none"
        named[f"searched: {broad}; half {half}"] = lobes
    dark = np.array(HELD_OUT) > 85.0
    for name, lobes in named.items():
        cells = [name]
        for database in databases.values():
            e = database.errors(lobes)
            cells += [f"{e.held_out[:, part].max():.2f}" for part in (~dark, dark)] + [f"{e.equation_4:.2f}"]
        rows.append(cells)
    table(header, rows, "worst ΔE00 at angles not used in the fit, and equation 4 over its RMS per paint")


def coats() -> None:
    """Print how coats are fitted with half lobes added: energy elsewhere, and f_r in the plane at 15°."""
    rings, fine = CoatSamples(), CoatSamples(first_ring_rad=2e-4, log_step=0.05, azimuths=12)
    exponents = default_basis().exponents
    octaves = tuple(2.0**k for k in range(2, 9))
    named = {
        "default": Lobes(exponents),
        "half octaves added": Lobes(exponents, octaves),
        # The cosine of E is about as wide as the half lobe of 2 E: what more lobes of any kind bring.
        "cosine octaves added": Lobes(tuple(sorted({*exponents, *(0.5 * e for e in octaves)}))),
    }
    rows = []
    for roughness in (0.02, 0.05, 0.08, 0.1, 0.2):
        coat = CoatLobe(1.5, roughness)
        cells = [f"{roughness:g}"]
        target, wanted = (
            (coat.eval(of.lights, of.view) * of.cosines[..., None]).mean(axis=1)[None, :, :1]
            for of in (rings, fine)
        )
        energy = rings.solid_angle @ target[0]
        whole = float((fine.solid_angle @ wanted[0])[0])
        seen = np.pi * coat.eval(illumination(45.0), aspecular_view(45.0, np.array([15.0])))[0, 0]
        for lobes in named.values():
            on_rings, on_fine = (
                of.lit[:, None] * lobes.of_cosine(np.cos(of.gamma_rad)) for of in (rings, fine)
            )
            matrix = np.concatenate([on_rings, (fine.solid_angle @ on_fine)[None]])
            weights = np.concatenate([rings.solid_angle, [ENERGY_WEIGHT]])
            kg = l1_program(matrix, weights, np.concatenate([target, energy[None, None]], axis=1))
            misplaced = 0.5 * float(fine.solid_angle @ np.abs(wanted[0] - on_fine @ kg[0])[:, 0]) / whole
            given = (
                np.pi / COSINE * float(lobes.of_cosine(np.cos(np.radians(np.array([15.0]))))[0] @ kg[0][:, 0])
            )
            cells += [f"{misplaced:.4f}", f"{given:.4f}"]
        rows.append([*cells, f"{seen:.4f}"])
    header = [
        "α",
        *(f"{name}: {what}" for name in named for what in ("misplaced", "ρ at 15°")),
        "the coat's ρ at 15°",
    ]
    table(header, rows, "satin and matte coats, n = 1.5")


def light(name: str) -> tuple[Floats, Floats]:
    """Return directions (k, 3) and radiance times solid angle (k, 3) of a shipped environment."""
    pixels = np.asarray(read_environment_image(resource("environments", name + ".exr")).pixels, np.float64)
    height, width = pixels.shape[:2]
    rings = np.sin(ring_angles(height))[:, None, None]
    shape = (ROWS, height // ROWS, 2 * ROWS, width // (2 * ROWS), 3)
    mean = (pixels * rings).reshape(shape).mean((1, 3)) / rings.reshape(ROWS, -1).mean(1)[:, None, None]
    towards = direction(ring_angles(ROWS)[:, None], column_angles(2 * ROWS)[None, :]).reshape(-1, 3)
    solid_angle = np.repeat(fejer_weights(ROWS) * np.pi / ROWS, 2 * ROWS)
    return towards, mean.reshape(-1, 3) * solid_angle[:, None]


def sphere() -> Floats:
    """Return normals (k, 3) evenly over the picture of a sphere."""
    rng = np.random.default_rng(1)
    radius, turn = np.sqrt(rng.uniform(0.0, 0.98, NORMALS)), rng.uniform(0.0, 2.0 * np.pi, NORMALS)
    return np.stack([radius * np.cos(turn), radius * np.sin(turn), np.sqrt(1.0 - radius**2)], axis=1)


def local(normals: Floats, directions: Floats) -> Floats:
    """Return world directions (k, 3) in the frame of each normal: (n, k, 3)."""
    tangent = VIEW - (normals @ VIEW)[:, None] * normals
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    frames = np.stack([tangent, np.cross(normals, tangent), normals], axis=1)
    return np.einsum("nij,kj->nki", frames, directions)


def transmitted(layers: Layered, cosine: Floats) -> Floats:
    """Return T(θ)²/T(45°)² (n, 1), by which the renderer takes the base; 1 where nothing covers it."""
    if not layers.base_under_coat:
        return np.ones((cosine.size, 1))
    share = (1.0 - fresnel_dielectric(cosine, layers.ior)) / (1.0 - fresnel_dielectric(COSINE, layers.ior))
    return np.asarray(share**2)[:, None]


def pictures(count: int | None) -> None:
    """Print mean ΔE00 of spheres in the shipped environments against the base itself, integrated."""
    normals = sphere()[: 10 * count if count else None]
    cosine = normals @ VIEW
    views = local(normals, VIEW[None])
    mirror = 2.0 * cosine[:, None] * normals - VIEW
    named = {name: lobes for name, lobes in sets().items() if not name.startswith("two")}
    forms = ("integrated", "looked up")
    errors: dict[tuple[str, str, str], list[float]] = {}
    for rule in RULES:
        chosen = list(paints(rule, count or 16).values())
        columns = {name: Database.of(chosen).fit(lobes) for name, lobes in named.items()}
        for environment in resource_names("environments", ".exr"):
            towards, power = light(environment)
            lights = local(normals, towards)
            lit = np.clip(lights[..., 2], 0.0, None)
            values = {
                name: lobes.of_cosine(np.clip(mirror @ towards.T, -1.0, 1.0)) for name, lobes in named.items()
            }
            diffuse = lit @ power
            weighed = {
                n: np.einsum("ntm,nt,tc->nmc", v, lit, power, optimize=True) for n, v in values.items()
            }
            maps = {n: np.einsum("ntm,tc->nmc", v, power, optimize=True) for n, v in values.items()}
            for place, layers in enumerate(chosen):
                true = np.einsum("ntc,tc,nt->nc", layers.base.eval(lights, views), power, lit)
                exposure = MIDDLE_GREY / np.median(true @ LUMINANCE)
                lab = working_to_lab(exposure * true)
                for name in named:
                    kd, kdd = columns[name][place][0], columns[name][place][1:]
                    for form, lobe_light in zip(
                        forms, (weighed[name], cosine[:, None, None] * maps[name]), strict=True
                    ):
                        seen = diffuse * kd + np.einsum("nmc,mc->nc", lobe_light, kdd)
                        seen = exposure * transmitted(layers, cosine) * seen
                        errors.setdefault((name, rule, form), []).append(
                            float(delta_e_2000(lab, working_to_lab(seen)).mean())
                        )
    header = ["lobes", *(f"{rule}: {form}" for rule in RULES for form in forms)]
    rows = [
        [name, *(f"{np.mean(errors[name, rule, form]):.2f}" for rule in RULES for form in forms)]
        for name in named
    ]
    table(header, rows, "mean ΔE00 of spheres in environment light, base alone")


def main() -> None:
    """Print all tables."""
    given = arguments(__doc__ or "")
    databases = {rule: Database.of(list(paints(rule, given.paints).values())) for rule in RULES}
    print(f"{len(databases['flake'].layers)} paints")
    readings(databases, 12 if given.paints else 120)
    coats()
    pictures(given.paints)


if __name__ == "__main__":
    main()
