/**
 * Hatching where the sun does not come.
 */
#ifndef Hatching_h
#define Hatching_h

#include "Polylines.h"
#include "SketchModel.h"

/// Lines of the surfaces in parallel planes, where these are in cast shadows or face away from the
/// sun, as they are then in their own way.
std::vector<Polyline3> Hatching(const Model& model);

#endif
