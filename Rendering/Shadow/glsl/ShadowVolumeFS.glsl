//VTK::System::Dec
//VTK::Output::Dec

// What a face counts, for a buffer of floats; with the stencil counting, colour is not written.
void main()
{
  gl_FragData[0] = vec4(gl_FrontFacing ? -1.0 : 1.0);
}
