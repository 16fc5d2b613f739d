/**
 * What the commands measured, as one JSON object.
 */
#ifndef Statistics_h
#define Statistics_h

#include "MeshReader.h"
#include "Numbers.h"

#include <nlohmann/json.hpp>

#include <string>

class vtkDataObject;

/// In the order in which values are put in.
using Json = nlohmann::ordered_json;

/// File, points and polygons of a mesh.
Json MeshStatistics(const Mesh& mesh);

/// What vtkSmoothLightSilhouette found wrong with the mesh, by count.
Json MeshDefects(vtkDataObject* silhouette);

/// First value of an array of the field data; null where there is none.
Json FieldValue(vtkDataObject* data, const std::string& array);

/// The object on standard output, or the line for people where json is off.
void PrintResult(bool json, const Json& statistics, const std::string& line);

#endif
