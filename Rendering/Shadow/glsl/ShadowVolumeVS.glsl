//VTK::System::Dec

// In coordinates of the mesh's own: a place, and 0 if the vertex is where the shadow of that place
// ends. Vertices of three components are places.
in vec4 vertex;

// Whether all vertices are ends.
uniform int endsOnly;

// The light, homogeneous, and a plane behind all that receives, positive in front; all zero if shadows
// end at infinity.
uniform vec4 light;
uniform vec4 end;
uniform mat4 volumeToClip;

void main()
{
  // Combined in clip coordinates, so that an end lies on the line through its place as that is drawn.
  vec4 place = volumeToClip * vec4(vertex.xyz, 1.0);
  if (vertex.w == 0.0 || endsOnly != 0)
  {
    vec4 ray = vec4(light.w * vertex.xyz - light.xyz, 0.0);
    float toward = dot(end.xyz, ray.xyz);
    float height = dot(end, vec4(vertex.xyz, 1.0));
    vec4 infinite = volumeToClip * ray;
    place = toward < 0.0 && height > 0.0 ? height * infinite - toward * place : infinite;
  }
  gl_Position = place;
}
