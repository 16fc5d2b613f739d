/**
 * Numbers and vectors as the command line gives them. Each is finite, or the option and the value
 * are named in a UsageError.
 */
#ifndef Numbers_h
#define Numbers_h

#include "Vectors.h"

#include <array>
#include <string>

double ParseNumber(const std::string& option, const std::string& text);

/// Above zero.
double ParsePositive(const std::string& option, const std::string& text);

/// From 1 to `largest`.
int ParseCount(const std::string& option, const std::string& text, int largest);

/// `x,y,z`
Vector3 ParseVector(const std::string& option, const std::string& text);

/// `x,y,z`, of any length but zero.
Vector3 ParseDirection(const std::string& option, const std::string& text);

/// `x,y,z[,w]`, not all zero; w is 1 where it is left out. What is not at infinity comes back with
/// w = 1.
Homogeneous ParseLight(const std::string& option, const std::string& text);

/// `WxH`
std::array<int, 2> ParseSize(const std::string& option, const std::string& text);

#endif
