/**
 * The change to the mappers' fragment shaders that brings the masks into their lighting.
 */
#ifndef MaskedLighting_h
#define MaskedLighting_h

#include <map>
#include <string>

/**
 * From a light's number (the N of `lightColorN`) to its mask.
 */
using LightMasks = std::map<int, int>;

/**
 * Multiplies each use of a masked light's colour by its mask. VTK's lighting models have in common
 * that all light comes out of these names, so the change is right for every one of them. A shader
 * without lights is left as it is, and so is one that has been changed already, as by a pass within
 * a pass.
 */
void MaskLighting(std::string& fragmentShader, const LightMasks& masks);

#endif
