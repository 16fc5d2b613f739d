/**
 * The sketch as an SVG, in plain lines.
 */
#ifndef SketchDrawing_h
#define SketchDrawing_h

#include "SketchLayers.h"

/// What is seen of the layers' lines. False if the file cannot be written.
bool WriteDrawing(const Model& model, const std::vector<Layer>& layers, const char* file);

#endif
