"""Analytic reflectance models with declared parameters, ``eval``, and samplers with pdfs.

A model is a frozen value with

- ``parameters``: a mapping of field names to :class:`brdf_suite.documents.parameter.Parameter`;
- ``reciprocal`` and ``energy_conserving``: what it claims; :mod:`brdf_suite.reflectance.checks` follows them;
- ``eval(wi, wo)``: f_r (..., 3), 1/sr, without the cosine, working space;
- ``sample(wo, u)`` with ``u`` (..., 3) in [0, 1): directions ``wi`` (..., 3), some of them below the horizon,
  where the light is lost; ``pdf(wi, wo)`` (...): their density per solid angle, 0 below the horizon. Both come from
  :class:`brdf_suite.reflectance.models.mixture.MixtureSampled`.
"""
