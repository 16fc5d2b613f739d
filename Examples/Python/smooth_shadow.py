#!/usr/bin/python3
"""A torus of 256 triangles over a plane: its smooth shadow, its silhouette and its shadow volume.

    PYTHONPATH=build/lib/python3.11/site-packages \\
        /usr/bin/python3 Examples/Python/smooth_shadow.py [picture.png]

The modules are built for the interpreter that the distribution's VTK belongs to: on Debian that is
/usr/bin/python3 with the package python3-vtk9, not another python that may come first on the PATH.
"""
import sys

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  what VTK draws with
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkCommonCore import vtkInformation
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource, vtkPlaneSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkWindowToImageFilter,
)

from smoothshadow.vtkFiltersShadow import vtkShadowVolumeExtruder, vtkSmoothLightSilhouette
from smoothshadow.vtkRenderingOffscreen import vtkOffscreenWindows
from smoothshadow.vtkRenderingShadow import vtkStencilShadowPass


def make_actor(source, colour, opacity=1.0):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(colour)
    actor.GetProperty().SetAmbient(0.15)
    actor.GetProperty().SetOpacity(opacity)
    return actor


def main(picture):
    lamp = (-3.0, -2.0, 5.0, 1.0)  # w = 1: a point, w = 0: a direction

    # A mesh with normals. VTK leaves the torus's seam open: closed meshes are faster to shadow.
    shape = vtkParametricTorus()
    shape.SetRingRadius(1.0)
    shape.SetCrossSectionRadius(0.4)
    sampled = vtkParametricFunctionSource()
    sampled.SetParametricFunction(shape)
    sampled.SetUResolution(17)
    sampled.SetVResolution(9)
    torus = vtkCleanPolyData()
    torus.SetInputConnection(sampled.GetOutputPort())
    torus.SetTolerance(1e-6)
    plane = vtkPlaneSource()
    plane.SetOrigin(-20.0, -20.0, -0.9)
    plane.SetPoint1(20.0, -20.0, -0.9)
    plane.SetPoint2(-20.0, 20.0, -0.9)

    # The filters, as in any pipeline.
    silhouette = vtkSmoothLightSilhouette()
    silhouette.SetInputConnection(torus.GetOutputPort())
    silhouette.SetLightPosition(lamp)
    volume = vtkShadowVolumeExtruder()
    volume.SetInputConnection(torus.GetOutputPort())
    volume.SetSilhouetteConnection(silhouette.GetOutputPort())
    volume.SetLength(2.0)
    volume.SetCapsToNone()
    tube = vtkTubeFilter()
    tube.SetInputConnection(silhouette.GetOutputPort())
    tube.SetRadius(0.02)
    tube.SetNumberOfSides(8)

    # A scene, as without shadows, and the pass.
    torus_actor = make_actor(torus, (0.91, 0.66, 0.42))
    plane_actor = make_actor(plane, (0.86, 0.86, 0.84))
    keys = vtkInformation()
    keys.Set(vtkStencilShadowPass.CASTS_SHADOW(), 0)
    plane_actor.SetPropertyKeys(keys)
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.PositionalOn()
    light.SetConeAngle(180.0)
    light.SetPosition(lamp[:3])
    light.SetIntensity(0.85)
    left = vtkRenderer()
    left.AddActor(torus_actor)
    left.AddActor(plane_actor)
    left.AddLight(light)
    left.SetBackground(0.80, 0.85, 0.90)
    left.SetViewport(0.0, 0.0, 0.5, 1.0)
    left.SetPass(vtkStencilShadowPass())

    # Silhouette and volume, drawn as the meshes that they are.
    right = vtkRenderer()
    right.AddActor(torus_actor)
    right.AddActor(make_actor(tube, (0.80, 0.15, 0.10)))
    right.AddActor(make_actor(volume, (0.35, 0.45, 0.65), opacity=0.35))
    right.SetBackground(1.0, 1.0, 1.0)
    right.SetViewport(0.5, 0.0, 1.0, 1.0)
    right.SetActiveCamera(left.GetActiveCamera())
    camera = left.GetActiveCamera()
    camera.SetPosition(2.0, -6.5, 4.0)
    camera.SetFocalPoint(0.4, 0.2, -0.4)
    camera.SetViewUp(0.0, 0.0, 1.0)

    # Any window of VTK that has a stencil buffer does; this one needs no display.
    window = vtkOffscreenWindows.NewWindow("egl")
    if not window:
        sys.exit(vtkOffscreenWindows.GetLastReason())
    window.SetSize(1200, 600)
    window.AddRenderer(left)
    window.AddRenderer(right)
    window.Render()

    capture = vtkWindowToImageFilter()
    capture.SetInput(window)
    capture.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(capture.GetOutputPort())
    writer.SetFileName(picture)
    writer.Write()
    print(f"{picture}: {silhouette.GetOutput().GetNumberOfLines()} silhouette loops")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "smooth_shadow.png")
