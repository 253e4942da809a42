"""Print the cost and the effect of each choice in the solver and its time limit (docs/method/fit.md).

python tests/benchmarks/comparisons/compare_limit.py [--paints N]
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.cli.tools.bench import load_module
from brdf_suite.errors import SuiteError, UnreachableError
from brdf_suite.fitting import LobeFitter
from brdf_suite.fitting.lobes import highs_model as solver_module
from brdf_suite.fitting.lobes.exact_vertex import refine_vertex
from brdf_suite.fitting.lobes.fallback import FallbackSolver
from brdf_suite.fitting.lobes.highs_model import BlockSolver, SolverOutcome
from brdf_suite.fitting.lobes.time_limit import LimitedSolver
from brdf_suite.reflectance.designed.build import build_paint

Targets = list[list[Floats]]

FITS, SEED = 400, 20_06
#: Random targets for every step of the drag, and steps for every target of the large program.
RANDOM_SHARE, ADVERSE_SHARE = 4, 10
PATIENCE_S = 60.0


def weighted(fitter: LobeFitter, base: Floats, coat: Floats) -> list[Floats]:
    """Return what the solver gets for samples of base and coat."""
    energy = fitter.coat_samples.solid_angle @ coat
    samples = (base, np.vstack([coat, energy]))
    return [p.row_weights[:, None] * s for p, s in zip(fitter.programs, samples, strict=True)]


def paints(fitter: LobeFitter, count: int) -> tuple[Targets, Targets]:
    """Return the targets of ``count`` steps of a drag and of as many unrelated paints."""
    drag = load_module(Path(__file__).parents[1] / "parts" / "fit_drag.py")
    rng = np.random.default_rng(SEED)
    near = [weighted(fitter, *fitter.sample(build_paint(drag.drag_paint(k, count)))) for k in range(count)]
    far: Targets = []
    while len(far) < count:
        try:
            far.append(weighted(fitter, *fitter.sample(build_paint(drag.unrelated_paint(rng)))))
        except UnreachableError:
            continue
    return near, far


def random_targets(fitter: LobeFitter, count: int) -> Targets:
    """Return ``count`` targets of no paint: any curve, and every third a sum of the lobes themselves."""
    rng = np.random.default_rng(SEED)
    gamma, exponents = fitter.coat_samples.gamma_rad, fitter.basis.array()
    found = []
    for number in range(count):
        base = rng.uniform(0.0, 1.0, (fitter.base_samples.gamma_rad.size, 3)) ** 3
        coat = np.exp(-np.outer(gamma**2, 10.0 ** rng.uniform(1.0, 5.0, 3)))
        if number % 3 == 0:
            shape = (exponents.size, 3)
            base = 0.1 + fitter.base_samples.cosine_lobes(exponents) @ rng.uniform(0.0, 1.0, shape)
            coat = fitter.coat_samples.cosine_lobes(exponents) @ rng.uniform(0.0, 1.0, shape)
        found.append(weighted(fitter, base, coat * rng.uniform(0.8, 1.2, coat.shape) if number % 3 else coat))
    return found


def ways(fitter: LobeFitter, near: Targets, far: Targets) -> None:
    """Print the time of the solver's ways for the suite's own program."""
    print(
        "\n| the suite's program, ms | drag: median | 99 % | unrelated: median | 99 % |\n|---|---|---|---|---|"
    )
    for name, inline, keep in (
        ("by the caller, vertex kept", True, True),
        ("by the caller, simplex each time", True, False),
        ("by the thread", False, False),
    ):
        solver = LimitedSolver(fitter.programs, inline=inline)
        cells = []
        for targets in (near, far):
            seconds = []
            for target in targets:
                if not keep:
                    solver.vertex = None
                start = time.perf_counter()
                # The thread's way begins with the feasible answers; a limit of 4 ms leaves the rest to wait.
                solver.solve(target, start + 0.004, finish=False)
                seconds.append(time.perf_counter() - start)
            cells += [f"{1e3 * np.percentile(seconds, q):.3f}" for q in (50, 99)]
        solver.close()
        print(f"| {name} | " + " | ".join(cells) + " |")


def tolerances(fitter: LobeFitter, targets: Targets) -> None:
    """Print how far the solver's answers are from the refined ones, by the factor on its costs."""
    print("\n| costs times | answers lost | off by more than 1e-7 | at worst | refined: off | at worst |")
    print("|---|---|---|---|---|---|")
    kept = solver_module.COST_SCALE
    sizes = [[t / np.where(t.sum(axis=0) > 0.0, t.sum(axis=0), 1.0) for t in target] for target in targets]
    plain: dict[float, Floats] = {}
    better: dict[float, Floats] = {}
    lost: dict[float, int] = {}
    for scale in (1.0, 1e3, 1e4, 1e5):
        solver_module.COST_SCALE = scale
        solver = BlockSolver(fitter.programs)
        rows, refinements, lost[scale] = [], [], 0
        for target in sizes:
            solver.load(target)
            if solver.run(PATIENCE_S) is not SolverOutcome.OPTIMAL:
                lost[scale] += 1
                solver.forget()
            held = solver.solution()
            answers = zip(fitter.programs, held.solutions, held.duals, target, strict=True)
            both = [(p.residual_l1(x, t), refine_vertex(p, x, y, t)[1]) for p, x, y, t in answers]
            rows.append(np.concatenate([row for row, _ in both]))
            refinements.append(np.concatenate([row for _, row in both]))
        plain[scale], better[scale] = np.array(rows), np.array(refinements)
    solver_module.COST_SCALE = kept
    best = np.minimum.reduce([*plain.values(), *better.values()])
    for scale in plain:
        gaps = [(found[scale] - best) / np.maximum(best, 1e-6) for found in (plain, better)]
        cells = " | ".join(f"{int((gap > 1e-7).sum())} of {gap.size} | {gap.max():.0e}" for gap in gaps)
        print(f"| {scale:g} | {lost[scale]} | {cells} |")


def adverse(count: int) -> None:
    """Print the solver's own limit on the large program, and the least squares by its steps."""
    limit = load_module(Path(__file__).parents[1] / "parts" / "fit_limit.py")
    gamma, program = limit.adversary()
    rng = np.random.default_rng(SEED)
    solver, fallback = BlockSolver([program]), FallbackSolver(program)
    targets = []
    for _ in range(count):
        target = program.row_weights[:, None] * limit.adverse_target(gamma, rng)
        targets.append(target / target.sum(axis=0))
    seconds = []
    for target in targets:
        solver.load([target])
        start = time.perf_counter()
        solver.run(limit.LIMIT_S)
        seconds.append(time.perf_counter() - start)
    print(
        f"\nHiGHS with a limit of {1e3 * limit.LIMIT_S:g} ms on 2,000×64 in three channels: median "
        f"{1e3 * np.median(seconds):.1f} ms, longest {1e3 * max(seconds):.1f} ms"
    )
    optima, whole = [], []
    for target in targets:
        solver.load([target])
        start = time.perf_counter()
        if solver.run(PATIENCE_S) is not SolverOutcome.OPTIMAL:
            raise SuiteError("The solver found no optimum of a program of the benchmark.")
        whole.append(time.perf_counter() - start)
        optima.append(program.residual_l1(solver.solution().solutions[0], target))
    print(f"to the optimum: median {1e3 * np.median(whole):.0f} ms, longest {1e3 * max(whole):.0f} ms")
    print("\n| steps of least squares | L1 error over the optimum's: median | 90 % | ms |\n|---|---|---|---|")
    for steps in (0, 5, 10, 20, 40):
        start = time.perf_counter()
        found = [fallback.least_squares(target, steps=steps) for target in targets]
        spent = 1e3 * (time.perf_counter() - start) / len(targets)
        pairs = zip(found, targets, optima, strict=True)
        ratios = [fallback.rescaled(x, target)[1] / optimum for x, target, optimum in pairs]
        print(f"| {steps} | {np.median(ratios):.2f} | {np.percentile(ratios, 90):.2f} | {spent:.2f} |")


def main() -> None:
    """Print all tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--paints", type=int, default=FITS, help="paints of the drag, and of the unrelated ones"
    )
    count = parser.parse_args().paints
    fitter = LobeFitter(time_limit_s=1.0)
    ways(fitter, *paints(fitter, count))
    tolerances(fitter, random_targets(fitter, RANDOM_SHARE * count))
    adverse(max(1, count // ADVERSE_SHARE))


if __name__ == "__main__":
    main()
