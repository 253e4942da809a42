"""A reflectance as coat and base."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.documents.cook_torrance import Clearcoat, CookTorranceLobe, CookTorrancePaint
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.reflectance.designed.build import build_paint, build_reflectance
from brdf_suite.reflectance.designed.layers import LARGEST_IOR, Layers, split_layers
from brdf_suite.reflectance.models.coated import Coated
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.registry import MODELS


def directions(count: int = 400) -> tuple[np.ndarray, np.ndarray]:
    """Random pairs, a few of them below the horizon, and half of them near the mirror direction."""
    rng = np.random.default_rng(4)
    wi, wo = rng.normal(size=(2, count, 3))
    wi[:, 2], wo[:, 2] = np.abs(wi[:, 2]), wo[:, 2] + 0.8
    wo[::2] = wi[::2] * (-1.0, -1.0, 1.0) + 0.02 * rng.normal(size=(count // 2, 3))
    return tuple(w / np.linalg.norm(w, axis=-1, keepdims=True) for w in (wi, wo))


@pytest.mark.parametrize("name", TABLE_1)
@pytest.mark.parametrize("clearcoat", [None, Clearcoat(1.5, 0.01)])
def test_the_layers_add_up_to_the_paint(name: str, clearcoat: Clearcoat | None) -> None:
    whole = build_reflectance(replace(TABLE_1[name], clearcoat=clearcoat))
    layers = split_layers(whole)
    assert layers is not None
    wi, wo = directions()
    np.testing.assert_allclose(
        layers.base.eval(wi, wo) + layers.coat.eval(wi, wo), whole.eval(wi, wo), rtol=1e-12, atol=1e-15
    )
    assert layers.coat.eval(np.array([0.0, 0.0, 1.0]), np.array([0.0, 0.0, 1.0])).min() > 0.0


def test_the_coat_is_the_sharp_lobes_and_its_index_reflects_r() -> None:
    layers = split_layers(CookTorrance(TABLE_1["table1_ford_f8"]))
    assert isinstance(layers, Layers)
    assert [lobe.m for lobe in layers.base.paint.lobes] == [0.32, 0.11]
    assert [lobe.m for lobe in layers.coat.paint.lobes] == [0.013]
    assert float(fresnel_dielectric(1.0, layers.ior)) == pytest.approx(0.9)
    assert not layers.base_under_coat


def test_several_sharp_lobes_share_one_index() -> None:
    layers = split_layers(CookTorrance(TABLE_1["table1_blue_matte"]))
    assert layers is not None
    assert 0.046 < float(fresnel_dielectric(1.0, layers.ior)) < 0.17


def test_without_a_sharp_lobe_there_is_no_coat() -> None:
    for lobes in ((), (CookTorranceLobe((0.2, 0.2, 0.2), 0.3, 0.5),)):
        model = CookTorrance(CookTorrancePaint("matt", (0.1, 0.2, 0.3), lobes))
        layers = split_layers(model)
        assert layers is not None
        assert layers.ior == 1.0
        wi, wo = directions()
        assert not layers.coat.eval(wi, wo).any()
        np.testing.assert_array_equal(layers.base.eval(wi, wo), model.eval(wi, wo))


def test_a_mirror_of_all_light_has_the_largest_index() -> None:
    for r in (1.0, 0.999999):
        paint = CookTorrancePaint("mirror", (0.0, 0.0, 0.0), (CookTorranceLobe((0.2, 0.2, 0.2), 0.01, r),))
        layers = split_layers(CookTorrance(paint))
        assert layers is not None
        assert layers.ior == LARGEST_IOR


def test_a_black_sharp_lobe_has_no_index() -> None:
    paint = CookTorrancePaint("black", (0.1, 0.1, 0.1), (CookTorranceLobe((0.0, 0.0, 0.0), 0.01, 0.04),))
    layers = split_layers(CookTorrance(paint))
    assert layers is not None
    assert layers.ior == 1.0


def test_designed_paints_and_other_clearcoats_have_their_own_layers() -> None:
    paint = build_paint(load_shipped_paint("blue"))
    assert split_layers(paint) is paint
    coated = Coated(Lambertian((0.6, 0.3, 0.2)), 1.4, 0.01)
    layers = split_layers(coated)
    assert layers is not None
    assert layers.ior == 1.4
    assert layers.coat == coated.coat
    wi, wo = directions()
    np.testing.assert_allclose(
        layers.base.eval(wi, wo) + layers.coat.eval(wi, wo), coated.eval(wi, wo), rtol=1e-12
    )


def test_what_nothing_divides_has_no_layers() -> None:
    for name in ("lambertian", "ggx", "lafortune"):
        assert split_layers(MODELS[name].default) is None
