/**
 * Where the scene is seen from and lit from, and the size of the sheet.
 */
#ifndef SketchView_h
#define SketchView_h

#include "Camera.h"

inline const Homogeneous Sun = { -0.75, -0.45, 1.0, 0.0 };
inline const Camera View = { { -0.75, -2.35, 1.35 }, { 0.44, 0.28, 0.43 }, { 0.0, 0.0, 1.0 },
  25.5 };
constexpr std::array<int, 2> Size = { 1200, 1000 }; // pixels

/// The eye, homogeneous.
inline const Homogeneous Eye = { View.Eye[0], View.Eye[1], View.Eye[2], 1.0 };

#endif
