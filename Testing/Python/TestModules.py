"""The wrapped modules import beside the distribution's VTK, whose pipelines take their classes."""
import math
import unittest

from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource

from smoothshadow.vtkFiltersShadow import (vtkCastShadowContour, vtkContourStrokes,
                                           vtkShadowedReceiver, vtkShadowMeshCheck,
                                           vtkShadowVolumeExtruder, vtkSilhouetteGap,
                                           vtkSmoothLightSilhouette)
from smoothshadow.vtkRenderingOffscreen import vtkOffscreenWindows
from smoothshadow.vtkRenderingShadow import vtkStencilShadowPass


class Modules(unittest.TestCase):
    def silhouette(self, source):
        silhouette = vtkSmoothLightSilhouette()
        silhouette.SetInputConnection(source.GetOutputPort())
        return silhouette

    def sphere(self):
        sphere = vtkSphereSource()
        sphere.SetThetaResolution(24)
        sphere.SetPhiResolution(16)
        sphere.SetOutputPointsPrecision(1)
        return sphere

    def test_defaults_and_properties(self):
        silhouette = vtkSmoothLightSilhouette()
        self.assertEqual(silhouette.GetLightPosition(), (0, 0, 1, 0))
        self.assertEqual(silhouette.GetKind(), vtkSmoothLightSilhouette.SMOOTH)
        silhouette.SetKindToDiscrete()
        self.assertEqual(silhouette.GetKind(), vtkSmoothLightSilhouette.DISCRETE)
        shadows = vtkStencilShadowPass()
        self.assertEqual(shadows.GetKind(), vtkStencilShadowPass.AUTOMATIC)
        for thing in (silhouette, shadows, vtkShadowVolumeExtruder(), vtkShadowMeshCheck(),
                      vtkCastShadowContour(), vtkShadowedReceiver(), vtkContourStrokes(),
                      vtkSilhouetteGap()):
            self.assertIn(thing.GetClassName(), str(thing))

    def test_silhouette_of_a_sphere(self):
        # Seen from (0, 0, 2) it is the circle at z = r^2 / 2.
        silhouette = self.silhouette(self.sphere())
        silhouette.SetLightPosition(0, 0, 2, 1)
        silhouette.Update()
        curves = silhouette.GetOutput()
        self.assertEqual(curves.GetNumberOfLines(), 1)
        self.assertGreater(curves.GetNumberOfPoints(), 20)
        for i in range(curves.GetNumberOfPoints()):
            x, y, z = curves.GetPoint(i)
            self.assertAlmostEqual(math.sqrt(x * x + y * y + z * z), 0.5, delta=2e-3)
            self.assertAlmostEqual(z, 0.125, delta=2e-3)

    def test_volume_is_closed(self):
        sphere = self.sphere()
        silhouette = self.silhouette(sphere)
        volume = vtkShadowVolumeExtruder()
        volume.SetInputConnection(sphere.GetOutputPort())
        volume.SetSilhouetteConnection(silhouette.GetOutputPort())
        volume.Update()
        self.assertGreater(volume.GetOutput().GetNumberOfPolys(), 100)
        self.assertEqual(volume.GetOutput().GetFieldData().GetArray("Closed").GetValue(0), 1)

    def test_strokes_of_a_silhouette(self):
        silhouette = self.silhouette(self.sphere())
        strokes = vtkContourStrokes()
        strokes.SetInputConnection(silhouette.GetOutputPort())
        strokes.SetWidth(0.02)
        strokes.SetWobble(1)
        strokes.Update()
        self.assertGreater(strokes.GetOutput().GetNumberOfPolys(), 100)
        self.assertEqual(strokes.GetOutput().GetFieldData().GetArray("NonFinitePoints").GetValue(0),
                         0)

    def test_contour_of_a_sphere_on_a_plane(self):
        # Its touching cone from (0, 0, 2) meets z = -1 in a circle of radius 3 / sqrt(15).
        sphere = self.sphere()
        silhouette = self.silhouette(sphere)
        silhouette.SetLightPosition(0, 0, 2, 1)
        plane = vtkPlaneSource()
        plane.SetOrigin(-4, -4, -1)
        plane.SetPoint1(4, -4, -1)
        plane.SetPoint2(-4, 4, -1)
        contour = vtkCastShadowContour()
        self.assertEqual(contour.GetBuilder(), vtkCastShadowContour.MORTON)
        contour.SetSilhouetteConnection(silhouette.GetOutputPort())
        contour.SetReceiverConnection(plane.GetOutputPort())
        contour.SetCasterConnection(sphere.GetOutputPort())
        contour.Update()
        curves = contour.GetOutput()
        self.assertEqual(curves.GetNumberOfLines(), 1)
        self.assertGreater(curves.GetNumberOfPoints(), 20)
        for i in range(curves.GetNumberOfPoints()):
            x, y, z = curves.GetPoint(i)
            self.assertAlmostEqual(math.hypot(x, y), 3 / math.sqrt(15), delta=1e-2)
            self.assertAlmostEqual(z, -1)

    def test_shadowed_area(self):
        # Of a disc of radius 3 / sqrt(15), as above; a parallelogram's other part is lit.
        sphere = self.sphere()
        silhouette = self.silhouette(sphere)
        silhouette.SetLightPosition(0, 0, 2, 1)
        plane = vtkPlaneSource()
        plane.SetOrigin(-4, -4, -1)
        plane.SetPoint1(4, -4, -1)
        plane.SetPoint2(-4, 4, -1)
        receiver = vtkShadowedReceiver()
        receiver.SetSilhouetteConnection(silhouette.GetOutputPort())
        receiver.SetReceiverConnection(plane.GetOutputPort())
        receiver.SetCasterConnection(sphere.GetOutputPort())
        receiver.Update()
        areas = receiver.GetOutput().GetFieldData()
        self.assertAlmostEqual(areas.GetArray("ShadowedArea").GetValue(0), 0.6 * math.pi, delta=0.02)
        self.assertAlmostEqual(areas.GetArray("ShadowedArea").GetValue(0)
                               + areas.GetArray("LitArea").GetValue(0), 64)
        self.assertEqual(areas.GetArray("TurnedAwayArea").GetValue(0), 0)

    def test_check_of_an_open_sphere(self):
        sphere = self.sphere()
        sphere.SetEndTheta(180)
        check = vtkShadowMeshCheck()
        self.assertTrue(check.GetCheckIntersections())
        check.SetInputConnection(sphere.GetOutputPort())
        check.Update()
        table = check.GetOutput()
        self.assertEqual(table.GetNumberOfRows(), 1)
        self.assertEqual([table.GetValueByName(0, column).ToString()
                          for column in ("Defect", "Meaning")], ["border edges", "exact"])
        self.assertGreater(table.GetValueByName(0, "Count").ToInt(), 20)
        self.assertEqual(table.GetFieldData().GetArray("ClosedParts").GetValue(0), 0)

    def test_empty_in_empty_out(self):
        silhouette = vtkSmoothLightSilhouette()
        silhouette.SetInputData(vtkPolyData())
        silhouette.Update()
        self.assertEqual(silhouette.GetOutput().GetNumberOfCells(), 0)

    def test_windows_say_why_not(self):
        self.assertIsNone(vtkOffscreenWindows.NewWindow("balcony"))
        self.assertIn("balcony", vtkOffscreenWindows.GetLastReason())


if __name__ == "__main__":
    unittest.main()
