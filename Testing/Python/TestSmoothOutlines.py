"""Runs the example of smooth outlines, and looks at its sphere.

    TestSmoothOutlines.py picture.png SmoothOutlines
"""
import math
import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "CommandLine"))
import Meshes

PICTURE, COMMAND = sys.argv[1:]
PANEL = 480


class SmoothOutlines(unittest.TestCase):
    def test_sphere_is_round_on_the_right(self):
        if os.path.exists(PICTURE):
            os.remove(PICTURE)
        run = subprocess.run([COMMAND, PICTURE], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertRegex(run.stdout, r"\A120 triangles and \d+ in the gap\n256 triangles and \d+ ")
        image = Meshes.Image(PICTURE)
        self.assertEqual((image.width, image.height), (3 * PANEL, 440))
        areas = []
        for panel in range(3):
            # Nothing else is as blue.
            sphere = [(x, y) for y in range(image.height) for x in range(PANEL)
                      for red, _, blue in [image.pixel(x + panel * PANEL + y * image.width)]
                      if blue > 1.3 * red]
            areas.append(len(sphere))
        # Up to pixels on its edge the last one is an ellipse that nothing hides.
        width, height = (max(values) - min(values) + 1 for values in zip(*sphere))
        self.assertAlmostEqual(areas[2] / (math.pi / 4 * width * height), 1, delta=0.01)
        for area in areas[:2]:
            self.assertLess(area, 0.97 * areas[2])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
