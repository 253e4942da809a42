"""Fits of fixed cosine lobes to a reflectance by linear programming, fast enough for interactive edits."""

from brdf_suite.fitting.lobes.basis import LobeBasis, default_basis, log_spaced
from brdf_suite.fitting.lobes.fitter import LayersFit, LobeFitter, PartError
from brdf_suite.fitting.lobes.weights import LobeWeights

__all__ = ["LayersFit", "LobeBasis", "LobeFitter", "LobeWeights", "PartError", "default_basis", "log_spaced"]
