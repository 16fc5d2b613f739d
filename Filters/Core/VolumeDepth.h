/// How often a shadow volume winds around a point at most.
#pragma once

#include "NearEnd.h"

namespace shadow
{
/// A number that the winding of an infinite volume far behind the caster does not exceed, and so
/// that of no point where all of the cap faces the light. (Where a corner field calls lit what
/// faces away, layers of the cap count -1 and points in front of them may lie in as many more.)
///
/// Seen from the light, the winding changes at the rims only. It is known in one direction,
/// the pole: 0 away from a caster that the light is outside of, else the count of the near cap's
/// triangles there. From the pole to any direction one comes along a meridian, on which it changes
/// at most by what runs across the meridian in one sense. Meridians are taken by sectors. Linear in
/// the rims; with the light inside also in the near cap, without which it is no bound there.
int greatestDepth(const NearEnd& end);
}
