"""Runs the example, which exists in C++ and in Python, and looks at its picture.

    TestExample.py picture.png command...
"""
import os
import subprocess
import sys
import unittest

from vtkmodules.vtkIOImage import vtkPNGReader

PICTURE, *COMMAND = sys.argv[1:]


class Example(unittest.TestCase):
    def test_picture(self):
        if os.path.exists(PICTURE):
            os.remove(PICTURE)
        run = subprocess.run([*COMMAND, PICTURE], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("2 silhouette loops", run.stdout)

        reader = vtkPNGReader()
        reader.SetFileName(PICTURE)
        reader.Update()
        width, height, _ = reader.GetOutput().GetDimensions()
        self.assertEqual((width, height), (1200, 600))
        data = bytes(memoryview(reader.GetOutput().GetPointData().GetScalars()))

        def pixels(first, last):
            return [data[3 * (x + y * width):3 * (x + y * width) + 3]
                    for y in range(height) for x in range(first, last)]

        # The lamp is the only light: in its shadow the ground is as dark as nothing else is grey.
        left = pixels(0, width // 2)
        dark = [p for p in left if max(p) < 60 and max(p) - min(p) < 6]
        self.assertGreater(len(dark), 20000)
        self.assertLess(len(dark), 80000)
        self.assertGreater(len(set(left)), 1000)
        # The silhouette's tubes are red.
        red = [p for p in pixels(width // 2, width) if p[0] > 120 and p[1] < 60 and p[2] < 60]
        self.assertGreater(len(red), 500)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
