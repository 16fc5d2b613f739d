/**
 * Checks of mesh files whose defects VTK 9.1's readers cannot be trusted with: a PLY file cut short
 * makes vtkPLYReader free memory twice, a binary STL file cut short is read without a word, and
 * vtkOBJReader takes a coordinate that is no number, `nan` among them, for 0.
 */
#ifndef FileStructure_h
#define FileStructure_h

#include <string>

/// What is wrong with the PLY file; empty if nothing is.
std::string PlyDefect(const std::string& file);

/// The same for an STL file; one in ASCII passes, as its reader is careful.
std::string StlDefect(const std::string& file);

/// The same for the points and normals of an OBJ file.
std::string ObjDefect(const std::string& file);

#endif
