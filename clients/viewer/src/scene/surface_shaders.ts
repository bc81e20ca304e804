// The graphics card draws the surface directly from the depth image: one vertex per pixel, placed by the camera model.
// Only the depth image is uploaded for each frame.

import {DEPTH_COLOR_GLSL} from './depth_color';

const COMMON = /* glsl */ `
precision highp float;
precision highp int;
uniform highp usampler2D depthSamples;
uniform ivec2 size;
uniform int stride;  // pixels between the vertices drawn
uniform float unit_m;

float depthAt(ivec2 pixel) {
  return float(texelFetch(depthSamples, clamp(pixel, ivec2(0), size - 1), 0).r) * unit_m;
}

// Largest depth difference of two neighbours on one surface [m]: near the camera, that of a steep slope; far away, one
// step of a disparity sensor, which grows with the square of the depth.
float largestStep(float z) { return 0.012 + 0.010 * z * z; }
`;

export const SURFACE_VERTEX = COMMON + /* glsl */ `
uniform vec4 intrinsics;  // fx, fy, cx, cy [pixels]
out vec2 grid;
out vec3 place;   // in the scene [m]
out vec3 facing;  // unit normal

// Averages the neighbours on the same surface, for display only. The hand feels the station's surface.
float smoothDepth(ivec2 pixel, float z) {
  float sum = 0.0;
  float count = 0.0;
  for (int row = -1; row <= 1; ++row)
    for (int column = -1; column <= 1; ++column) {
      float other = depthAt(pixel + ivec2(column, row));
      if (other > 0.0 && abs(other - z) < largestStep(z)) {
        sum += other;
        count += 1.0;
      }
    }
  return sum / max(count, 1.0);
}

vec3 placeOf(vec2 pixel, float z) {
  vec2 tangent = (pixel - intrinsics.zw) / intrinsics.xy;
  return vec3(tangent.x * z, -tangent.y * z, -z);
}

// The neighbour some pixels away if it is on the same surface, else the pixel itself.
vec3 neighbour(ivec2 pixel, ivec2 away, float z) {
  float other = depthAt(pixel + away);
  bool same = other > 0.0 && abs(other - z) < 4.0 * largestStep(z);
  return same ? placeOf(vec2(pixel + away), other) : placeOf(vec2(pixel), z);
}

void main() {
  ivec2 pixel = ivec2(gl_VertexID % size.x, gl_VertexID / size.x);
  float z = depthAt(pixel);
  grid = vec2(pixel);
  if (z == 0.0) {  // every triangle of this vertex is discarded; only its place in the grid matters
    place = vec3(0.0);
    facing = vec3(0.0, 0.0, 1.0);
    gl_Position = projectionMatrix * modelViewMatrix * vec4(placeOf(vec2(pixel), 1.0), 1.0);
    return;
  }
  place = placeOf(vec2(pixel), smoothDepth(pixel, z));
  vec3 across = neighbour(pixel, ivec2(4, 0), z) - neighbour(pixel, ivec2(-4, 0), z);
  vec3 down = neighbour(pixel, ivec2(0, 4), z) - neighbour(pixel, ivec2(0, -4), z);
  vec3 crossed = cross(down, across);
  facing = dot(crossed, crossed) > 0.0 ? normalize(crossed) : vec3(0.0, 0.0, 1.0);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(place, 1.0);
}
`;

export const SURFACE_FRAGMENT = COMMON + DEPTH_COLOR_GLSL + /* glsl */ `
uniform sampler2D colorPicture;
uniform float colored;       // 1: from the picture, 0: by depth
uniform bool plain;           // by depth in the colours of skin: no colour picture has come
uniform vec2 range_m;        // near, far, for colour by depth
uniform vec3 touchedAt;      // the proxy, in the scene
uniform float touched;       // 0 untouched … 1 pressed hard
uniform vec3 touchColor;
uniform vec3 eye;
uniform float opacity;
in vec2 grid;
in vec3 place;
in vec3 facing;
out vec4 color;

void keepWithinOneSurface() {
  ivec2 cell = clamp(ivec2(floor(grid / float(stride))) * stride, ivec2(0), size - 1 - stride);
  vec2 inside = grid - vec2(cell);
  float right = depthAt(cell + ivec2(stride, 0));
  float below = depthAt(cell + ivec2(0, stride));
  float corner = depthAt(inside.x + inside.y < float(stride) ? cell : cell + stride);
  float nearest = min(corner, min(right, below));
  float farthest = max(corner, max(right, below));
  if (nearest == 0.0 || farthest - nearest > float(stride) * largestStep(nearest)) discard;
}

vec3 byDepth() {
  float share = clamp((-place.z - range_m.x) / max(range_m.y - range_m.x, 0.02), 0.0, 1.0);
  if (plain) return mix(vec3(0.78, 0.66, 0.58), vec3(0.10, 0.17, 0.24), share);
  return pow(depthColor(share), vec3(2.2));  // to linear light
}

void main() {
  keepWithinOneSurface();
  vec3 base = mix(byDepth(), texture(colorPicture, (grid + 0.5) / vec2(size)).rgb, colored);
  vec3 towardsEye = normalize(eye - place);
  vec3 towardsLamp = normalize(vec3(-0.45, 0.65, 0.85));
  float lamp = max(dot(facing, towardsLamp), 0.0);
  float front = max(dot(facing, towardsEye), 0.0);
  float light = mix(0.45, 0.62, colored) + mix(0.55, 0.36, colored) * lamp + 0.12 * front;
  vec3 lit = base * light;

  float away_m = distance(place, touchedAt);
  float glow = touched * exp(-away_m * away_m / (2.0 * 0.016 * 0.016));
  float ring = touched * smoothstep(0.0025, 0.0, abs(away_m - 0.030));
  vec3 marked = mix(lit, touchColor, clamp(0.55 * glow + 0.6 * ring, 0.0, 0.85));
  color = linearToOutputTexel(vec4(marked, opacity));
}
`;
