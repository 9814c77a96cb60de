#include "openr/render/shaders.h"

namespace openr_host::render {

const char kDepthVertexShader[] = R"(#version 120
uniform mat4 light_from_world;
uniform mat4 world_from_shape;
void main() { gl_Position = light_from_world * (world_from_shape * gl_Vertex); }
)";

const char kDepthFragmentShader[] = R"(#version 120
void main() {}
)";

const char kPictureVertexShader[] = R"(#version 120
uniform mat4 picture_from_world;
uniform mat4 world_from_shape;
uniform mat4 sun_from_world;
uniform mat4 sky_from_world;
varying vec3 place;
varying vec3 normal;
varying vec3 in_sun;
varying vec3 in_sky;
void main() {
  vec4 world = world_from_shape * gl_Vertex;
  place = world.xyz;
  normal = mat3(world_from_shape) * gl_Normal;
  // The point is moved a little off the surface, so that the surface does not shade itself.
  vec4 lifted = vec4(place + 0.0015 * normalize(normal), 1.0);
  in_sun = 0.5 + 0.5 * (sun_from_world * lifted).xyz;
  in_sky = 0.5 + 0.5 * (sky_from_world * lifted).xyz;
  gl_Position = picture_from_world * world;
}
)";

// Draws a point of a surface in the light of the sun, with soft shadows, and in the light of the
// sky, which is weaker below other shapes.  Surfaces with gloss reflect the sun.  The grid on the
// floor fades into the background with distance.
const char kPictureFragmentShader[] = R"(#version 120
uniform sampler2DShadow sun_depth;
uniform sampler2DShadow sky_depth;
uniform vec3 eye;
uniform vec3 to_sun;
uniform vec3 colour;
uniform vec3 background;
uniform vec3 centre;
uniform float gloss;
uniform float softness;  // larger values make the borders of shadows softer
uniform float glow;
uniform float grid;   // distance of the lines on the floor; 0: not the floor
uniform float reach;  // distance at which the floor has faded away
varying vec3 place;
varying vec3 normal;
varying vec3 in_sun;
varying vec3 in_sky;

// Returns the share, 0 to 1, of `samples` points in a disc that are lit.  Neighbouring pixels turn
// the disc by different angles, and the program later averages neighbouring pixels, which smooths
// the result.  Points outside the depth picture count as lit.
float Lit(sampler2DShadow depth, vec3 at, float radius, float samples) {
  float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  float lit = 0.0;
  for (float i = 0.5; i < samples; i += 1.0) {
    float angle = turn + 2.3999632 * i;
    float r = radius * sqrt(i / samples);
    vec2 p = at.xy + r * vec2(cos(angle), sin(angle));
    bool is_outside = any(lessThan(p, vec2(0.0))) || any(greaterThan(p, vec2(1.0)));
    lit += is_outside ? 1.0 : shadow2D(depth, vec3(p, at.z)).r;
  }
  return lit / samples;
}

float Line(float x, float width) {
  float from_line = abs(fract(x - 0.5) - 0.5);
  float blur = fwidth(x);
  return (1.0 - smoothstep(width, width + blur, from_line)) * clamp(width / blur * 4.0, 0.0, 1.0);
}

void main() {
  vec3 n = normalize(normal);
  vec3 to_eye = normalize(eye - place);
  vec3 base = colour * colour;  // approximates linear light
  float fade = 0.0;
  if (grid > 0.0) {
    vec2 cell = place.xy / grid;
    float lines = max(Line(cell.x, 0.008), Line(cell.y, 0.008));
    float heavy = max(Line(cell.x / 5.0, 0.003), Line(cell.y / 5.0, 0.003));
    base *= 1.0 - 0.16 * lines - 0.14 * heavy;
    fade = smoothstep(0.25 * reach, reach, length(place.xy - centre.xy));
  }
  float facing = max(dot(n, to_sun), 0.0);
  float sun = facing > 0.0 ? facing * Lit(sun_depth, in_sun, 0.006 * softness, 24.0) : 0.0;
  float open = Lit(sky_depth, in_sky, softness * (grid > 0.0 ? 0.030 : 0.012), 32.0);
  float sky = (0.55 + 0.45 * n.z) * mix(0.45, 1.0, open);
  vec3 light = sun * vec3(1.02, 0.98, 0.90) + sky * vec3(0.40, 0.43, 0.48) +
               0.10 * max(-n.z, 0.0) * vec3(1.0, 0.95, 0.9);
  vec3 shade = base * light;
  vec3 between = normalize(to_sun + to_eye);
  float sharp = mix(12.0, 90.0, gloss);
  shade += gloss * 0.55 * pow(max(dot(n, between), 0.0), sharp) * step(0.001, sun);
  float rim = pow(1.0 - max(dot(n, to_eye), 0.0), 4.0);
  shade += gloss * rim * 0.22 * mix(0.4, 1.0, open);
  shade = mix(shade, base * 1.6 + 0.10, glow);
  gl_FragColor = vec4(mix(sqrt(shade), background, fade), 1.0);
}
)";

}  // namespace openr_host::render
