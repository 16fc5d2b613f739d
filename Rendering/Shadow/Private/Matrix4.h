/**
 * 4 x 4 matrices in double, row by row, acting on column vectors. vtkMatrix4x4 is a reference
 * counted object; a caster's matrices are values.
 */
#ifndef Matrix4_h
#define Matrix4_h

#include "vtkMatrix4x4.h"

#include <algorithm>
#include <array>

using Matrix4 = std::array<double, 16>;

inline Matrix4 ToMatrix4(vtkMatrix4x4* matrix)
{
  Matrix4 result;
  std::copy_n(matrix->GetData(), 16, result.begin());
  return result;
}

inline Matrix4 Transposed(const Matrix4& matrix)
{
  Matrix4 result;
  vtkMatrix4x4::Transpose(matrix.data(), result.data());
  return result;
}

inline Matrix4 operator*(const Matrix4& left, const Matrix4& right)
{
  Matrix4 result;
  vtkMatrix4x4::Multiply4x4(left.data(), right.data(), result.data());
  return result;
}

inline Matrix4 Translation(const std::array<double, 3>& offset)
{
  return { 1.0, 0.0, 0.0, offset[0], 0.0, 1.0, 0.0, offset[1], 0.0, 0.0, 1.0, offset[2], 0.0, 0.0,
    0.0, 1.0 };
}

#endif
