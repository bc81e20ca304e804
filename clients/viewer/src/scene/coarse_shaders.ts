// The surface for browsers without a graphics card: light and colour by depth are computed for each vertex, and a pixel
// costs one texture look-up. All colours stay encoded for the screen (sRGB): conversion would cost each pixel a pow().

import {DEPTH_COLOR_GLSL} from './depth_color';

export const COARSE_VERTEX = DEPTH_COLOR_GLSL + /* glsl */ `
in vec2 pixel;
in float lamp;
uniform vec2 size;
uniform vec2 range_m;        // near, far, for colour by depth
uniform bool plain;          // true until a colour picture comes: colour by depth, in skin tones
uniform float colored;
out vec2 at;
out vec3 place;              // in the scene [m]
out vec3 base;
out float shade;

const float TO_SCREEN = 1.0 / 2.2;

vec3 byDepth(float depth_m) {
  float share = clamp((depth_m - range_m.x) / max(range_m.y - range_m.x, 0.02), 0.0, 1.0);
  return plain ? pow(mix(vec3(0.78, 0.66, 0.58), vec3(0.10, 0.17, 0.24), share), vec3(TO_SCREEN)) : depthColor(share);
}

void main() {
  at = (pixel + 0.5) / size;
  place = position;
  base = byDepth(-position.z);
  shade = pow(mix(0.45, 0.62, colored) + mix(0.55, 0.36, colored) * lamp + 0.10, TO_SCREEN);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}
`;

export const COARSE_FRAGMENT = /* glsl */ `
uniform sampler2D colorPicture;
uniform vec3 touchedAt;      // the proxy, in the scene
uniform float touched;       // 0 untouched … 1 pressed hard
uniform vec3 touchScreenColor;
uniform float opacity;
in vec2 at;
in vec3 place;
in vec3 base;
in float shade;
out vec4 color;

void main() {
#ifdef COLORED
  vec3 lit = shade * texture(colorPicture, at).rgb;
#else
  vec3 lit = shade * base;
#endif
  if (touched > 0.0) {
    vec3 off = place - touchedAt;
    float away2 = dot(off, off);
    float glow = clamp(1.0 - away2 / 0.0012, 0.0, 1.0);
    float ring = clamp(1.0 - abs(away2 - 0.0009) / 0.00015, 0.0, 1.0);
    lit = mix(lit, touchScreenColor, touched * min(0.85, 0.55 * glow * glow + 0.6 * ring));
  }
  color = vec4(lit, opacity);
}
`;
