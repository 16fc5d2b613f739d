//VTK::System::Dec

// From the mesh's coordinates; w is 0 for vertices at infinity.
in vec4 homogeneous;
uniform mat4 volumeToClip;

void main()
{
  gl_Position = volumeToClip * homogeneous;
}
