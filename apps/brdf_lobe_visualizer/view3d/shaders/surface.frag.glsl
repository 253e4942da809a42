// Provides: the colour of a lobe surface, lit from beside the eye; whole, like glass, or as the lines of its grid.
// Needs: surface.vert.glsl; `style` 0 solid, 1 glass, 2 lines.
#version 330 core

in vec3 eye_point;
in vec3 eye_normal;
in vec3 surface_colour;
in vec2 place;

uniform int style;
uniform vec4 tint;        // what the colour is mixed with, and how much
uniform float opacity;
uniform vec2 line_steps;  // rows and columns from line to line
uniform float line_width; // device pixels

out vec4 result;

const vec3 TO_LIGHT = vec3(-0.36, 0.48, 0.80);

vec3 decoded(vec3 codes) {
    return mix(codes / 12.92, pow((codes + 0.055) / 1.055, vec3(2.4)), step(vec3(0.04045), codes));
}

vec3 encoded(vec3 light) {
    return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), light));
}

// How much of a pixel the nearest line covers. Where lines lie closer than pixels, about a spike, they are one grey.
float lines() {
    vec2 at = place / line_steps;
    vec2 per_pixel = max(fwidth(at), vec2(1e-6));
    vec2 away = abs(fract(at - 0.5) - 0.5) / per_pixel;
    vec2 cover = clamp(0.5 * line_width + 0.5 - away, 0.0, 1.0);
    cover = mix(cover, vec2(0.45), smoothstep(0.25, 0.6, per_pixel));
    return max(cover.x, cover.y);
}

void main() {
    vec3 normal = normalize(eye_normal);
    vec3 to_eye = normalize(-eye_point);
    // A lobe without its rim shows its inside, which is lit from within and darker.
    bool inside = dot(normal, to_eye) < 0.0;
    if (inside) normal = -normal;
    float lit = max(dot(normal, normalize(TO_LIGHT)), 0.0);
    float rim = pow(1.0 - abs(dot(normal, to_eye)), 3.0);
    vec3 light = decoded(mix(surface_colour, tint.rgb, tint.a));
    light *= (inside ? 0.55 : 1.0) * (0.30 + 0.10 * normal.y + 0.68 * lit) * (1.0 - 0.25 * rim);
    float alpha = opacity;
    if (style == 1) alpha = mix(opacity, 1.0, 0.65 * rim);
    if (style == 2) {
        alpha = opacity * lines();
        if (alpha < 0.02) discard;
        light = decoded(mix(surface_colour, tint.rgb, tint.a)) * (inside ? 0.6 : 1.0);
    }
    result = vec4(encoded(clamp(light, 0.0, 1.0)), alpha);
}
