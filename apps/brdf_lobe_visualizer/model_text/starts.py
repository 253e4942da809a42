"""Texts that a new model begins with; their comments are English in every language, as are the notations."""

from __future__ import annotations

from brdf_suite.reflectance.live.text import Language

STARTS: dict[Language, str] = {
    "glsl": """\
analytic

# float NAME minimum maximum default; bool NAME 0 or 1; color NAME red green blue
::begin parameters
color base .6 .1 .05
float roughness .02 1 .25
bool clearcoat 1
::end parameters

# L: to the light, V: to the viewer, N: normal, X and Y: tangents. Returns f_r in 1/sr, without the cosine.
::begin shader
const float PI = 3.14159265358979323846;

float schlick(float f0, float u)
{
    float m = clamp(1.0 - u, 0.0, 1.0);
    return f0 + (1.0 - f0) * m * m * m * m * m;
}

vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y)
{
    vec3 H = normalize(L + V);
    float NdotH = max(dot(N, H), 0.0), LdotH = max(dot(L, H), 0.0);
    float a2 = roughness * roughness * roughness * roughness;
    float d = NdotH * NdotH * (a2 - 1.0) + 1.0;
    float lobe = a2 / (PI * d * d) * schlick(0.04, LdotH) / (4.0 * max(LdotH * LdotH, 0.01));
    return base / PI + (clearcoat ? vec3(lobe) : vec3(0.0));
}
::end shader
""",
    "python": """\
# number(minimum, maximum, default), switch(0 or 1), color(red, green, blue)
# L: to the light, V: to the viewer, N: normal, X and Y: tangents. Returns f_r in 1/sr, without the cosine.


def schlick(f0, u):
    return f0 + (1 - f0) * clip(1 - u, 0, 1) ** 5


def brdf(L, V, N, X, Y,
         base=color(0.6, 0.1, 0.05),
         roughness=number(0.02, 1, 0.25),
         clearcoat=switch(1)):
    H = normalize(L + V)
    LdotH = max(dot(L, H), 0)
    a2 = roughness ** 4
    d = dot(N, H) ** 2 * (a2 - 1) + 1
    lobe = a2 / (pi * d ** 2) * schlick(0.04, LdotH) / (4 * max(LdotH ** 2, 0.01))
    return base / pi + (lobe if clearcoat else 0)
""",
}
