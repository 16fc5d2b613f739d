// The defects of a mesh as a table: what each means for the shadow, and what to do about it.
#ifndef DefectTable_h
#define DefectTable_h

struct CheckedMesh;
class vtkTable;

// Writes the columns and field data that vtkShadowMeshCheck documents.
void writeDefects(const CheckedMesh& checked, vtkTable* output);

#endif
