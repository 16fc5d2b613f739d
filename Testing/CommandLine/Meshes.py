"""Small meshes and pictures for the tests of the command line."""
import base64
import json
import struct
import xml.etree.ElementTree

from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkFiltersCore import vtkCleanPolyData
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource, vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

SPHERE_TRIANGLES = 168


def sphere():
    source = vtkSphereSource()
    source.SetThetaResolution(12)
    source.SetPhiResolution(9)
    source.SetOutputPointsPrecision(1)
    source.Update()
    return source.GetOutput()


def write_sphere(path, binary=True):
    """In the format that the path ends in."""
    extension = path.rsplit(".", 1)[1]
    if extension == "gltf":
        return write_gltf_sphere(path)
    writer = {"ply": vtkPLYWriter, "stl": vtkSTLWriter, "obj": vtkOBJWriter,
              "vtk": vtkPolyDataWriter, "vtp": vtkXMLPolyDataWriter}[extension]()
    if extension in ("ply", "stl", "vtk"):
        (writer.SetFileTypeToBinary if binary else writer.SetFileTypeToASCII)()
    if extension == "vtp":
        (writer.SetDataModeToAppended if binary else writer.SetDataModeToAscii)()
    writer.SetInputData(sphere())
    writer.SetFileName(path)
    writer.Write()
    return path


def write_broken_sphere(path, value, point=None):
    """A VTP file with that value for one coordinate, of one point or of all; returns how many
    triangles it touches."""
    mesh = sphere()
    ids = range(mesh.GetNumberOfPoints()) if point is None else [point]
    for i in ids:
        x, _, z = mesh.GetPoint(i)
        mesh.GetPoints().SetPoint(i, x, value, z)
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(mesh)
    writer.SetFileName(path)
    writer.Write()
    return sum(any(mesh.GetCell(c).GetPointId(i) in ids for i in range(3))
               for c in range(mesh.GetNumberOfCells()))


def write_gltf_sphere(path):
    mesh = sphere()
    points = [mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())]
    ids = [mesh.GetCell(c).GetPointId(i) for c in range(mesh.GetNumberOfCells()) for i in range(3)]
    data = b"".join(struct.pack("<3f", *p) for p in points)
    offset = len(data)
    data += struct.pack(f"<{len(ids)}I", *ids)
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    low = [min(p[axis] for p in points) for axis in range(3)]
    high = [max(p[axis] for p in points) for axis in range(3)]
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": len(data), "uri": uri}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": offset},
                        {"buffer": 0, "byteOffset": offset, "byteLength": len(data) - offset}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(points),
                       "type": "VEC3", "min": low, "max": high},
                      {"bufferView": 1, "componentType": 5125, "count": len(ids),
                       "type": "SCALAR"}],
    }
    with open(path, "w") as file:
        json.dump(document, file)
    return path


def write_torus(path, radius=1, tube=0.4, height=0):
    """Around y, coarse, with the normals of the smooth one."""
    shape = vtkParametricTorus()
    shape.SetRingRadius(radius)
    shape.SetCrossSectionRadius(tube)
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(shape)
    source.SetUResolution(25)
    source.SetVResolution(17)
    source.SetOutputPointsPrecision(1)
    welded = vtkCleanPolyData()
    welded.SetInputConnection(source.GetOutputPort())
    welded.SetTolerance(1e-6)
    welded.SetOutputPointsPrecision(1)
    welded.Update()
    mesh = welded.GetOutput()
    normals = mesh.GetPointData().GetNormals()
    for i in range(mesh.GetNumberOfPoints()):
        x, y, z = mesh.GetPoint(i)
        mesh.GetPoints().SetPoint(i, y, z + height, x)
        x, y, z = normals.GetTuple3(i)
        normals.SetTuple3(i, y, z, x)
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(mesh)
    writer.SetFileName(path)
    writer.Write()
    return path


def write_obj(path, points, faces):
    with open(path, "w") as file:
        for point in points:
            file.write("v {} {} {}\n".format(*point))
        for face in faces:
            file.write("f " + " ".join(str(i + 1) for i in face) + "\n")
    return path


def write_tetrahedron(path, apex=(0, 0, 1)):
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), apex]
    return write_obj(path, points, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])


def write_box(path, low, high):
    points = [tuple((high if corner >> axis & 1 else low)[axis] for axis in range(3))
              for corner in range(8)]
    return write_obj(path, points, [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3),
                                    (0, 2, 3, 1), (4, 5, 7, 6)])


def write_ground(path, half, height=0):
    """Facing y."""
    points = [(x, height, z) for x, z in ((-half, -half), (-half, half), (half, half),
                                          (half, -half))]
    return write_obj(path, points, [(0, 1, 2, 3)])


def read_polydata(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


class Drawing:
    """Width, height and viewBox of an SVG file, and by the ids of its layers the points of their
    paths: a list of pieces each, closed ones with their first point again."""

    def __init__(self, path):
        space = "{http://www.w3.org/2000/svg}"
        inkscape = "{http://www.inkscape.org/namespaces/inkscape}"
        root = xml.etree.ElementTree.parse(path).getroot()
        if root.tag != space + "svg":
            raise ValueError(root.tag)
        self.width, self.height = root.get("width"), root.get("height")
        self.view = [float(number) for number in root.get("viewBox").split()]
        self.layers, self.labels = {}, {}
        for group in root:
            if group.tag != space + "g" or group.get(inkscape + "groupmode") != "layer":
                raise ValueError(group.tag)
            self.labels[group.get("id")] = group.get(inkscape + "label")
            self.layers[group.get("id")] = [self.pieces(path.get("d")) for path in group]

    @staticmethod
    def pieces(data):
        pieces = []
        for text in data.split("M")[1:]:
            points = [tuple(float(number) for number in pair.split(","))
                      for pair in text.rstrip("Z").replace("L", " ").split()]
            pieces.append(points + points[:1] if text.endswith("Z") else points)
        return pieces


class Image:
    """Width, height, channels and bytes of a PNG file."""

    def __init__(self, path):
        reader = vtkPNGReader()
        reader.SetFileName(path)
        reader.Update()
        image = reader.GetOutput()
        self.width, self.height, _ = image.GetDimensions()
        self.channels = image.GetNumberOfScalarComponents()
        self.data = bytes(memoryview(image.GetPointData().GetScalars()))

    def pixel(self, index):
        return self.data[index * self.channels:(index + 1) * self.channels]
