// Provides: vec3 lab_of_relative(vec3 relative), float delta_e_2000(vec3 lab1, vec3 lab2)
// Needs:    nothing
//
// CIE 1976 L*a*b* of tristimulus values over those of the white, and CIEDE2000 between two of them (ISO/CIE
// 11664-6, hue conventions of Sharma, Wu and Dalal 2005). The same in numpy: appearance/colour/colorimetry.py and
// appearance/difference/formulas.py.
vec3 lab_of_relative(vec3 relative)
{
    const float EDGE = 6.0 / 29.0;
    vec3 root = sign(relative) * pow(abs(relative), vec3(1.0 / 3.0));
    vec3 line = relative / (3.0 * EDGE * EDGE) + 4.0 / 29.0;
    vec3 f = mix(line, root, vec3(greaterThan(relative, vec3(EDGE * EDGE * EDGE))));
    return vec3(116.0 * f.y - 16.0, 500.0 * (f.x - f.y), 200.0 * (f.y - f.z));
}

// chroma^7 / (chroma^7 + 25^7), in an order that no large chroma overflows.
float chroma_share(float chroma)
{
    float ratio = 25.0 / max(chroma, 1e-4);
    float ratio2 = ratio * ratio;
    return chroma < 0.01 ? 0.0 : 1.0 / (1.0 + ratio2 * ratio2 * ratio2 * ratio);
}

float delta_e_2000(vec3 lab1, vec3 lab2)
{
    const float PI = 3.14159265359;
    const float DEGREE = PI / 180.0;
    float stretch = 1.5 - 0.5 * sqrt(chroma_share(0.5 * (length(lab1.yz) + length(lab2.yz))));
    vec2 ab1 = vec2(lab1.y * stretch, lab1.z);
    vec2 ab2 = vec2(lab2.y * stretch, lab2.z);
    float c1 = length(ab1), c2 = length(ab2);
    bool grey = c1 * c2 == 0.0;
    float h1 = c1 == 0.0 ? 0.0 : atan(ab1.y, ab1.x);
    float h2 = c2 == 0.0 ? 0.0 : atan(ab2.y, ab2.x);
    h1 += h1 < 0.0 ? 2.0 * PI : 0.0;
    h2 += h2 < 0.0 ? 2.0 * PI : 0.0;

    float turn = h2 - h1;
    turn += turn > PI ? -2.0 * PI : turn < -PI ? 2.0 * PI : 0.0;
    float delta_h = grey ? 0.0 : 2.0 * sqrt(c1 * c2) * sin(0.5 * turn);
    float total = h1 + h2;
    float mean_h = grey ? total
        : 0.5 * (abs(h1 - h2) <= PI ? total : total < 2.0 * PI ? total + 2.0 * PI : total - 2.0 * PI);

    float mean_l = 0.5 * (lab1.x + lab2.x), mean_c = 0.5 * (c1 + c2);
    float t = 1.0 - 0.17 * cos(mean_h - 30.0 * DEGREE) + 0.24 * cos(2.0 * mean_h)
        + 0.32 * cos(3.0 * mean_h + 6.0 * DEGREE) - 0.20 * cos(4.0 * mean_h - 63.0 * DEGREE);
    float away = (mean_h / DEGREE - 275.0) / 25.0;
    float swing = 30.0 * DEGREE * exp(-away * away);
    float rotation = -sin(2.0 * swing) * 2.0 * sqrt(chroma_share(mean_c));
    float middle = (mean_l - 50.0) * (mean_l - 50.0);
    float lightness = (lab2.x - lab1.x) / (1.0 + 0.015 * middle / sqrt(20.0 + middle));
    float chroma = (c2 - c1) / (1.0 + 0.045 * mean_c);
    float hue = delta_h / (1.0 + 0.015 * mean_c * t);
    return sqrt(max(lightness * lightness + chroma * chroma + hue * hue + rotation * chroma * hue, 0.0));
}
