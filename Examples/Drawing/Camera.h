/**
 * From where a drawing or picture is seen.
 */
#ifndef Camera_h
#define Camera_h

#include "Vectors.h"

struct Camera
{
  Vector3 Eye;
  Vector3 At;
  Vector3 Up;
  double Angle; // vertical, degrees
};

#endif
