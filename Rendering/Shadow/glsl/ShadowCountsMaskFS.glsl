//VTK::System::Dec
//VTK::Output::Dec

// As many shadow volumes as lie around each pixel's surface; whole numbers, exactly.
uniform sampler2D counts;

void main()
{
  if (texelFetch(counts, ivec2(gl_FragCoord.xy), 0).r == 0.0)
  {
    discard;
  }
  gl_FragData[0] = vec4(0.0);
}
