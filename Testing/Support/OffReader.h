/**
 * @brief Reads OFF files, which VTK does not.
 *
 * Tolerant: a missing keyword, prefixes (C, N, ST), comments, empty lines, counts on the keyword's
 * line, colours and normals behind coordinates and faces, several records on a line. Polygons stay
 * polygons; faces of fewer than three corners are left out. Points are double.
 */
#ifndef shadowtest_OffReader_h
#define shadowtest_OffReader_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace shadowtest
{
/// Throws std::runtime_error that names the file and what is wrong with it.
vtkSmartPointer<vtkPolyData> readOff(const std::string& path);
}

#endif
