"""Runs the architectural sketch, and looks for the lines of its SVG in its picture.

    TestSketch.py sketch.png sketch.svg ArchitecturalSketch
"""
import collections
import math
import os
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "CommandLine"))
import Meshes

PICTURE, DRAWING, COMMAND = sys.argv[1:]
BUNNY = "/usr/share/glmark2/models/bunny.obj"
WIDTH, HEIGHT = 1200, 1000
INK = 150  # below: the palest line is 0.42 of 255, and blurred where it is thin
WHITE = 250


class Sketch(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        for file in (PICTURE, DRAWING):
            if os.path.exists(file):
                os.remove(file)
        animal = [BUNNY] if os.path.exists(BUNNY) else []
        run = subprocess.run([COMMAND, PICTURE, DRAWING, *animal], capture_output=True, text=True)
        if run.returncode != 0:
            raise RuntimeError(run.stderr)
        cls.image = Meshes.Image(PICTURE)
        cls.drawing = Meshes.Drawing(DRAWING)

    def places(self, layer):
        """Pixels about every 3 pixels along the layer's lines, but for their ends, where strokes
        taper."""
        scale = HEIGHT / self.drawing.view[3]
        for path in self.drawing.layers[layer]:
            for piece in path:
                points = [(x * scale + WIDTH / 2, y * scale + HEIGHT / 2) for x, y in piece]
                length = sum(map(math.dist, points, points[1:]))
                done = 0
                for a, b in zip(points, points[1:]):
                    count = int(math.dist(a, b) / 3) + 1
                    for i in range(count):
                        x, y = (p + (q - p) * i / count for p, q in zip(a, b))
                        at = done + math.dist(a, (x, y))
                        inside = 4 < x < WIDTH - 5 and 4 < y < HEIGHT - 5
                        if inside and 0.15 * length < at < 0.85 * length:
                            yield int(x), int(y)
                    done += math.dist(a, b)

    def around(self, x, y, reach):
        """Rows go downwards, as those of the SVG; the picture's upwards."""
        return [self.image.pixel(column + (HEIGHT - 1 - row) * WIDTH)[0]
                for row in range(y - reach, y + reach + 1)
                for column in range(x - reach, x + reach + 1)]

    def test_picture_and_drawing_agree(self):
        self.assertEqual((self.image.width, self.image.height), (WIDTH, HEIGHT))
        self.assertEqual(list(self.drawing.layers),
                         ["hatching", "contours", "animal-contours", "creases", "outlines"])
        for layer in self.drawing.layers:
            places = list(self.places(layer))
            self.assertGreater(len(places), 100, layer)
            # Strokes are up to 2 pixels beside their lines, and over other lines at times.
            inked = sum(min(self.around(x, y, 3)) < INK for x, y in places)
            self.assertGreater(inked, 0.97 * len(places), layer)
        ink = sum(self.image.pixel(i)[0] < INK for i in range(WIDTH * HEIGHT))
        self.assertGreater(ink, 0.01 * WIDTH * HEIGHT)
        self.assertLess(ink, 0.08 * WIDTH * HEIGHT)

    def test_hatching_is_where_the_pass_has_shadow(self):
        places = list(self.places("hatching"))
        self.assertGreater(len(places), 2000)
        # What is around a line most is paper, in light or shadow.
        shadowed = sum(collections.Counter(value for value in self.around(x, y, 4) if value > INK)
                       .most_common(1)[0][0] < WHITE for x, y in places)
        self.assertGreater(shadowed, 0.95 * len(places))


class SmoothOutlines(unittest.TestCase):
    """Of a sphere of 48 triangles, in front of the chair's back."""

    def draw(self, folder, *options):
        names = [os.path.join(folder, name) for name in ("out.png", "out.svg", "sphere.obj")]
        points = [(0, 1, 0), (0, -1, 0)]
        for ring in (1, 2, 3):
            for i in range(8):
                y, along = math.cos(ring * math.pi / 4), i * math.pi / 4
                radius = math.sin(ring * math.pi / 4)
                points.append((radius * math.sin(along), y, radius * math.cos(along)))
        faces = []
        for i in range(8):
            this, after = 2 + i, 2 + (i + 1) % 8
            faces += [(0, this, after), (1, after + 16, this + 16)]
            faces += [(at, at + 8, after + at - this + 8, after + at - this)
                      for at in (this, this + 8)]
        Meshes.write_obj(names[2], points, faces)
        subprocess.run([COMMAND, *options, *names], check=True, capture_output=True)
        return Meshes.Image(names[0]), Meshes.Drawing(names[1])

    def test_only_the_gap_is_filled(self):
        with tempfile.TemporaryDirectory() as folder:
            plain, _ = self.draw(folder)
            filled, drawing = self.draw(folder, "--smooth-outlines")
        scale = HEIGHT / drawing.view[3]
        outline = [(x * scale + WIDTH / 2, y * scale + HEIGHT / 2)
                   for path in drawing.layers["outlines"] for piece in path for x, y in piece]
        self.assertGreater(len(outline), 50)
        left, right = (choose(x for x, _ in outline) for choose in (min, max))
        top, bottom = (choose(y for _, y in outline) for choose in (min, max))
        changed = [(i % WIDTH, HEIGHT - 1 - i // WIDTH) for i in range(WIDTH * HEIGHT)
                   if plain.pixel(i) != filled.pixel(i)]
        self.assertGreater(len(changed), 1000)
        # Facets turn by 45 degrees: the gap is some 0.08 of the radius, about 15 pixels, wide.
        for x, y in changed:
            self.assertTrue(left - 2 <= x <= right + 2 and top - 2 <= y <= bottom + 2)
        centre = ((left + right) / 2, (top + bottom) / 2)
        radius = (right - left) / 2
        for place in changed:
            self.assertGreater(math.dist(place, centre), 0.8 * radius)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
