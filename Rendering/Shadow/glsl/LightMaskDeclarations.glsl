
// Visibility of four lights a layer, which multiplies the lights' colours. Without a mask, as in
// the depth stage, all lights are visible.
const int stencilShadowLayers = LAYER_COUNT;
vec4 stencilShadow[LAYER_COUNT];
uniform sampler2DArray stencilShadowMasks;
uniform int stencilShadowMasked;

// Window to mask coordinates: they differ by the viewport's origin, and by scale in passes that
// draw larger than the window.
uniform vec2 stencilShadowOrigin;
uniform vec2 stencilShadowScale;

void stencilShadowFetch()
{
  ivec2 size = textureSize(stencilShadowMasks, 0).xy;
  ivec2 texel = ivec2((gl_FragCoord.xy - stencilShadowOrigin) * stencilShadowScale);
  texel = clamp(texel, ivec2(0), size - ivec2(1));
  for (int layer = 0; layer < stencilShadowLayers; ++layer)
  {
    stencilShadow[layer] = stencilShadowMasked == 0
      ? vec4(1.0)
      : texelFetch(stencilShadowMasks, ivec3(texel, layer), 0);
  }
}

