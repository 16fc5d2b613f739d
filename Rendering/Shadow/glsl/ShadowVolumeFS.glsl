//VTK::System::Dec
//VTK::Output::Dec

// What a front face counts, for a buffer of floats; with the stencil counting, colour is not
// written.
uniform float frontCounts;

void main()
{
  gl_FragData[0] = vec4(gl_FrontFacing ? frontCounts : -frontCounts);
}
