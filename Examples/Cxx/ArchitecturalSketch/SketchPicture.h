/**
 * The sketch as a picture: strokes over surfaces of paper, on which the shadow pass lays a wash.
 */
#ifndef SketchPicture_h
#define SketchPicture_h

#include "SketchLayers.h"

/// `smoothOutlines`: whether the animal's triangles are filled up to its smooth outline, which the
/// strokes follow. False, with a message, if there is no window or the file cannot be written.
bool WritePicture(
  const Model& model, const std::vector<Layer>& layers, bool smoothOutlines, const char* file);

#endif
