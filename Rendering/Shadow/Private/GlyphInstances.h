/**
 * The glyphs that a vtkGlyph3DMapper draws.
 */
#ifndef GlyphInstances_h
#define GlyphInstances_h

#include "CasterMeshes.h"

#include <vector>

class vtkGlyph3DMapper;

/**
 * For each point of the input, in each visible block of it, the meshes of its source with the
 * point's matrix: T R S, as the mapper orders translation, orientation and scaling.
 */
std::vector<CasterMesh> CollectGlyphs(vtkGlyph3DMapper* mapper);

#endif
