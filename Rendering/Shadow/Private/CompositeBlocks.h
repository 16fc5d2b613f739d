/**
 * The blocks of composite data that mappers draw.
 */
#ifndef CompositeBlocks_h
#define CompositeBlocks_h

#include <vector>

class vtkActor;
class vtkCompositePolyDataMapper2;
class vtkDataObject;
class vtkPolyData;

/**
 * All meshes among the leaves, as vtkCompositePolyDataMapper draws them.
 */
std::vector<vtkPolyData*> CollectBlocks(vtkDataObject* data);

/**
 * Those that are visible and opaque, as vtkCompositePolyDataMapper2 decides: a block has its own
 * visibility and opacity, or else those of the block that it is in; texture and scalars must be
 * opaque as well.
 */
std::vector<vtkPolyData*> CollectOpaqueBlocks(vtkCompositePolyDataMapper2* mapper, vtkActor* actor);

#endif
