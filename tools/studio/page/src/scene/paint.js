// SPDX-License-Identifier: Apache-2.0
// What surfaces are painted with. Light, fog and the screen's colours are worked out at the corners
// of triangles, which lie close together: at each pixel, as three.js does it, they are half of what
// a picture costs where GL runs on the processor.
import { LineBasicMaterial, MeshBasicMaterial, MeshLambertMaterial } from "three";

/** What dark colours are lifted by, so that they are seen on a dark ground; 0 on a light one. */
export const lift = { value: 0 };

const LIT = /* glsl */ `
  vec3 n = normalize(normalMatrix * normal);
  vec3 light = ambientLightColor;
  #if NUM_HEMI_LIGHTS > 0
    for (int i = 0; i < NUM_HEMI_LIGHTS; i++)
      light += getHemisphereLightIrradiance(hemisphereLights[i], n);
  #endif
  #if NUM_DIR_LIGHTS > 0
    for (int i = 0; i < NUM_DIR_LIGHTS; i++)
      light += saturate(dot(n, directionalLights[i].direction)) * directionalLights[i].color;
  #endif
  float edge = 1.0 - abs(n.z);
  float dark = clamp(1.0 - 8.0 * max(diffuse.r, max(diffuse.g, diffuse.b)), 0.0, 1.0);
  vec3 tint = diffuse + lift * dark * (1.0 + 2.0 * edge * edge);
  paint = emissive + tint * RECIPROCAL_PI * light;`;

const FOG = /* glsl */ `
#ifdef USE_FOG
  uniform vec3 fogColor;
  uniform float fogNear;
  uniform float fogFar;
  vec3 inFog(vec3 colour, float depth) {
    return mix(colour, fogColor, smoothstep(fogNear, fogFar, depth));
  }
#else
  vec3 inFog(vec3 colour, float depth) { return colour; }
#endif`;

const vertexShader = (lit, long) => /* glsl */ `
uniform vec3 diffuse;
varying vec3 paint;
#include <common>
#include <colorspace_pars_fragment>
${lit ? "uniform vec3 emissive;\nuniform float lift;\n#include <lights_pars_begin>" : ""}
${long ? "varying float depth;" : FOG}
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * seen;
  ${lit ? LIT : "paint = diffuse;"}
  paint = sRGBTransferOETF(vec4(paint, 1.0)).rgb;
  ${long ? "depth = -seen.z;" : "paint = inFog(paint, -seen.z);"}
}`;

const fragmentShader = (long) => /* glsl */ `
uniform float opacity;
varying vec3 paint;
${long ? `varying float depth;${FOG}` : ""}
void main() {
  gl_FragColor = vec4(${long ? "inFog(paint, depth)" : "paint"}, opacity);
}`;

/**
 * A material of three.js whose colour is worked out at the corners.
 * @param {{lit?: boolean, long?: boolean}} what `lit`: light falls on it; `long`: its corners are
 * so far apart that fog is worked out at each pixel
 */
const painted = (Material, { lit = false, long = false } = {}) =>
  class extends Material {
    onBeforeCompile(shader) {
      if (lit) shader.uniforms.lift = lift;
      shader.vertexShader = vertexShader(lit, long);
      shader.fragmentShader = fragmentShader(long);
    }

    customProgramCacheKey() {
      return `painted ${lit} ${long}`;
    }
  };

/** Of bodies. */
export const LitPaint = painted(MeshLambertMaterial, { lit: true });
/** Of one colour from all sides. */
export const FlatPaint = painted(MeshBasicMaterial);
export const LinePaint = painted(LineBasicMaterial, { long: true });
