"""Drives the tool as a user does: exit codes, messages, files and figures.

    SMOOTHSHADOW=build/bin/smoothshadow /usr/bin/python3 TestCommandLine.py [Class]...
"""
import fcntl
import json
import math
import os
import pty
import re
import resource
import shutil
import signal
import struct
import subprocess
import tempfile
import termios
import unittest

import Meshes

TOOL = os.environ["SMOOTHSHADOW"]
BUNNY = "/usr/share/glmark2/models/bunny.obj"
BUNNY_TRIANGLES = 69666
CAT = "/usr/share/glmark2/models/cat.3ds"


class ToolTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="smoothshadow-")
        self.addCleanup(shutil.rmtree, self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)

    def run_tool(self, *arguments, tool=TOOL, **options):
        return subprocess.run([tool, *arguments], capture_output=True, text=True, timeout=240,
                              cwd=self.folder, **options)

    def succeed(self, *arguments, **options):
        run = self.run_tool(*arguments, **options)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stderr, "")
        return run.stdout

    def statistics(self, *arguments, **options):
        return json.loads(self.succeed(*arguments, "--json", **options))

    def fail_with(self, code, *arguments, **options):
        """One line of error, nothing on standard output, no file made or changed."""
        before = sorted(os.listdir(self.folder))
        run = self.run_tool(*arguments, **options)
        self.assertEqual(run.returncode, code, f"{arguments}: {run.stderr}")
        self.assertRegex(run.stderr, r"\Asmoothshadow: error: [^\n]+\n\Z")
        self.assertEqual(run.stdout, "")
        self.assertEqual(sorted(os.listdir(self.folder)), before)
        return run.stderr

    def fail_in(self, file, what, *arguments, **options):
        """Exit code 1, and the line says WHAT, in WHICH FILE, what to do."""
        message = self.fail_with(1, *arguments, **options)
        pattern = r"\Asmoothshadow: error: .*" + what + ".*, in " + re.escape(file) + r", .+\n\Z"
        self.assertRegex(message, pattern)


class GoodRuns(ToolTest):
    def render(self, mesh, name, *options):
        """Statistics and picture."""
        statistics = self.statistics("render", mesh, "-o", name, *options)
        return statistics, Meshes.Image(self.path(name))

    def test_bunny_in_every_kind(self):
        size = ("--ground", "--size", "240x180")
        plain, unshadowed = self.render(BUNNY, "none.png", "--kind", "none", *size)
        self.assertEqual(plain["lights"][0]["shadowedPixels"], 0)
        self.assertGreater(len(set(unshadowed.data)), 50)
        for kind in ("discrete", "accurate", "smooth"):
            statistics, picture = self.render(
                BUNNY, kind + ".png", "--kind", kind, "--mask", "mask.png", *size)
            mask = Meshes.Image(self.path("mask.png"))
            self.check_statistics(statistics, kind)
            self.check_pictures(statistics, unshadowed, picture, mask)

    def test_plan_and_counting(self):
        common = (BUNNY, "out.png", "--ground", "--size", "240x180")
        shadowed = {}
        for counting, expected in (("auto", "z-pass"), ("zpass", "z-pass"), ("zfail", "z-fail")):
            statistics, _ = self.render(*common, "--counting", counting, "--plan")
            row, = [row for row in statistics["plan"] if row["caster"] == 0]
            self.assertTrue(row["decision"].startswith(expected))
            self.assertTrue(row["reason"])
            shadowed[counting] = statistics["lights"][0]["shadowedPixels"]
        # The eye is in the light here: both are right, up to pixels on an edge.
        self.assertEqual(shadowed["auto"], shadowed["zpass"])
        self.assertLess(abs(shadowed["auto"] - shadowed["zfail"]), 0.01 * shadowed["zfail"])
        text = self.succeed("render", BUNNY, "-o", "out.png", "--ground", "--size", "240x180",
                            "--plan")
        self.assertRegex(text, r"\Aframe: depth drawn; .+ ms\n"
                         r"light 0, caster 0: z-pass, .+; .+ ms\n"
                         r"light 0: .+; .+ ms\nframe: shading; .+ ms\n")
        statistics, _ = self.render(*common)
        self.assertIn("mask of before", [row["decision"] for row in statistics["plan"]])
        self.assertIn("--counting", self.fail_with(
            2, "render", BUNNY, "-o", "out.png", "--counting", "sometimes"))

    def test_pixel_tolerance(self):
        decisions = {}
        for tolerance in ("0.001", "100"):
            statistics, _ = self.render(BUNNY, "out.png", "--ground", "--size", "240x180", "--plan",
                                        "--pixel-tolerance", tolerance)
            decisions[tolerance], = [
                row["decision"] for row in statistics["plan"] if row["caster"] == 0]
        self.assertIn("smooth", decisions["0.001"])
        self.assertIn("discrete", decisions["100"])
        self.assertIn("--pixel-tolerance", self.fail_with(
            2, "render", BUNNY, "-o", "out.png", "--pixel-tolerance", "0"))

    def check_statistics(self, statistics, kind):
        self.assertEqual(statistics["kind"], kind)
        self.assertEqual((statistics["width"], statistics["height"]), (240, 180))
        self.assertTrue(statistics["renderer"])
        self.assertGreater(statistics["frameMilliseconds"], 0)
        self.assertEqual(statistics["meshes"][0]["triangles"], BUNNY_TRIANGLES)
        self.assertEqual(statistics["meshes"][0]["normals"], "computed")

    def check_pictures(self, statistics, unshadowed, picture, mask):
        for image, channels in ((unshadowed, 3), (picture, 3), (mask, 1)):
            self.assertEqual((image.width, image.height, image.channels), (240, 180, channels))
        self.assertEqual(set(mask.data), {0, 255})
        shadowed = mask.data.count(0)
        self.assertEqual(statistics["lights"][0]["shadowedPixels"], shadowed)
        self.assertGreater(shadowed, 0.03 * len(mask.data))
        self.assertLess(shadowed, 0.5 * len(mask.data))
        darker = 0
        for i, visible in enumerate(mask.data):
            before, after = unshadowed.pixel(i), picture.pixel(i)
            if visible:
                self.assertLessEqual(max(abs(a - b) for a, b in zip(before, after)), 1)
            else:
                self.assertLessEqual(max(a - b for a, b in zip(after, before)), 1)
                darker += sum(before) > sum(after) + 30
        # On the ground, at least, the light that is taken away is missed.
        self.assertGreater(darker, 0.3 * shadowed)

    def test_repeats_exactly(self):
        for name in ("first.png", "second.png"):
            self.succeed("render", BUNNY, "-o", name, "--ground", "--size", "160x120")
        self.assertEqual(Meshes.Image(self.path("first.png")).data,
                         Meshes.Image(self.path("second.png")).data)

    def test_frames_and_moving_lights_leave_the_picture(self):
        mesh = Meshes.write_sphere(self.path("sphere.vtp"))
        _, still = self.render(mesh, "still.png", "--ground", "--size", "160x120")
        statistics, moved = self.render(
            mesh, "moved.png", "--ground", "--size", "160x120", "--frames", "3", "--move-lights")
        self.assertEqual(statistics["frames"], 3)
        self.assertTrue(statistics["lightsMoved"])
        self.assertEqual(still.data, moved.data)

    def test_several_lights_and_meshes(self):
        sphere = Meshes.write_sphere(self.path("sphere.vtp"))
        tetrahedron = Meshes.write_tetrahedron(self.path("tetrahedron.obj"))
        statistics, _ = self.render(
            sphere, "picture.png", tetrahedron, "--ground", "--size", "160x120", "--mask",
            "mask.png", "--light", "-2,3,1", "--light", "1,2,.5,0", "--light=-4,6,2,2")
        lights = statistics["lights"]
        self.assertEqual([light["position"] for light in lights],
                         [[-2, 3, 1, 1], [1, 2, 0.5, 0], [-2, 3, 1, 1]])
        self.assertEqual([light["mask"] for light in lights],
                         ["mask.png", "mask-2.png", "mask-3.png"])
        masks = [Meshes.Image(self.path(light["mask"])).data for light in lights]
        self.assertEqual([mask.count(0) for mask in masks],
                         [light["shadowedPixels"] for light in lights])
        self.assertEqual(masks[0], masks[2])
        self.assertNotEqual(masks[0], masks[1])
        self.assertEqual(len(statistics["meshes"]), 2)

    def test_supersampling_keeps_size_and_shadow(self):
        mesh = Meshes.write_sphere(self.path("sphere.vtp"))
        once, _ = self.render(mesh, "once.png", "--ground", "--size", "160x120")
        thrice, picture = self.render(
            mesh, "thrice.png", "--ground", "--size", "160x120", "--supersample", "3")
        self.assertEqual((picture.width, picture.height), (160, 120))
        pixels = once["lights"][0]["shadowedPixels"]
        self.assertGreater(pixels, 500)
        self.assertAlmostEqual(
            thrice["lights"][0]["shadowedPixels"], pixels, delta=0.05 * pixels)

    def test_camera_is_the_users(self):
        mesh = Meshes.write_sphere(self.path("sphere.vtp"))
        statistics, _ = self.render(mesh, "picture.png", "--size", "64x64", "--eye", "-1,2,9",
                                    "--at", "0,.1,0", "--up", "0,0,1", "--angle", "20")
        self.assertEqual(statistics["camera"],
                         {"eye": [-1, 2, 9], "at": [0, 0.1, 0], "up": [0, 0, 1], "angle": 20})
        self.render(mesh, "above.png", "--size", "64x64", "--eye", "0,9,0", "--at", "0,0,0")

    def test_mesh_fits_into_the_picture(self):
        # A border that is all background: the default camera cuts nothing off.
        mesh = Meshes.write_tetrahedron(self.path("tetrahedron.obj"), apex=(0.2, 5, 1))
        for size in ("200x80", "80x200"):
            _, picture = self.render(mesh, "picture.png", "--size", size, "--kind", "none")
            border = [x + y * picture.width for y in range(picture.height)
                      for x in range(picture.width)
                      if x in (0, picture.width - 1) or y in (0, picture.height - 1)]
            self.assertEqual(len({picture.pixel(i) for i in border}), 1)
            self.assertGreater(len(set(picture.data)), 6)


class Formats(ToolTest):
    def test_every_format(self):
        names = ["a.ply", "a.stl", "a.obj", "a.vtk", "a.vtp", "a.gltf", "a.PLY"]
        meshes = [Meshes.write_sphere(self.path(name.lower()), binary)
                  for name in names[:6] for binary in (False, True)]
        os.rename(self.path("a.ply"), self.path("a.PLY"))
        for name in names[1:]:
            with self.subTest(name):
                statistics = self.statistics("volume", name, "-o", "out.vtp", "--light", "1,2,3")
                self.assertEqual(statistics["mesh"]["polygons"], Meshes.SPHERE_TRIANGLES)
                self.assertEqual(statistics["mesh"]["boundaryEdges"], 0)
                self.assertTrue(statistics["closed"])
        self.assertEqual(len(meshes), 12)

    def test_ascii(self):
        for name in ("a.ply", "a.stl", "a.vtk", "a.vtp"):
            with self.subTest(name):
                Meshes.write_sphere(self.path(name), binary=False)
                statistics = self.statistics("volume", name, "-o", "out.vtp", "--light", "1,2,3")
                self.assertEqual(statistics["mesh"]["polygons"], Meshes.SPHERE_TRIANGLES)

    def test_3ds(self):
        statistics = self.statistics("render", CAT, "-o", "cat.png", "--up", "0,0,1", "--ground",
                                     "--size", "160x120")
        self.assertGreater(statistics["meshes"][0]["triangles"], 1000)
        self.assertGreater(statistics["lights"][0]["shadowedPixels"], 300)


class SilhouetteAndVolume(ToolTest):
    def test_silhouette(self):
        for kind in ("discrete", "accurate", "smooth"):
            with self.subTest(kind):
                statistics = self.statistics("silhouette", BUNNY, "-o", "out.vtp", "--light",
                                             "-2,3,4", "--kind", kind, "--repeat", "3")
                curves = Meshes.read_polydata(self.path("out.vtp"))
                self.check_silhouette(statistics, curves, kind)

    def check_silhouette(self, statistics, curves, kind):
        self.assertEqual(statistics["kind"], kind)
        self.assertEqual(statistics["loops"], curves.GetNumberOfLines())
        self.assertEqual(statistics["points"], curves.GetNumberOfPoints())
        self.assertGreater(statistics["loops"], 10)
        self.assertGreater(statistics["milliseconds"], 0)
        self.assertEqual(statistics["mesh"]["polygons"], BUNNY_TRIANGLES)
        self.assertEqual(statistics["mesh"]["nonFiniteCells"], 0)
        for loop in range(curves.GetNumberOfLines()):
            ids = curves.GetCell(loop).GetPointIds()
            self.assertEqual(ids.GetId(0), ids.GetId(ids.GetNumberOfIds() - 1))
        self.assertEqual(curves.GetPoints().GetData().GetDataTypeAsString(), "double")
        self.assertEqual(curves.GetPointData().GetArray("Normals").GetDataTypeAsString(), "double")
        self.assertEqual(curves.GetFieldData().GetArray("LightPosition").GetTuple(0),
                         (-2, 3, 4, 1))
        deviation = curves.GetFieldData().GetArray("MaximumDeviation").GetValue(0)
        self.assertEqual(statistics["maximumDeviation"], deviation)

    def test_tolerance(self):
        Meshes.write_sphere(self.path("sphere.vtp"))
        common = ("silhouette", "sphere.vtp", "-o", "out.vtp", "--light", "1,2,3")
        coarse = self.statistics(*common, "--tolerance", "1e-2")
        fine = self.statistics(*common, "--tolerance", "1e-6")
        world = self.statistics(*common, "--tolerance", "1e-6", "--tolerance-mode", "world")
        self.assertGreater(fine["points"], coarse["points"])
        self.assertLessEqual(world["maximumDeviation"], 1e-6)
        self.assertGreaterEqual(world["points"], fine["points"])

    def test_tolerance_on_receivers(self):
        Meshes.write_sphere(self.path("sphere.vtp"))
        ground = [(-9, -9, -4), (9, -9, -4), (9, 9, -4), (-9, 9, -4)]
        Meshes.write_obj(self.path("ground.obj"), ground, [(0, 1, 2, 3)])
        Meshes.write_obj(
            self.path("far.obj"), [(x, y, 50 * z) for x, y, z in ground], [(0, 1, 2, 3)])
        common = ("silhouette", "sphere.vtp", "-o", "out.vtp", "--light", "0.1,0.2,4",
                  "--tolerance",
                  "1e-3", "--tolerance-mode", "receiver", "--receiver", "ground.obj")
        near = self.statistics(*common)
        both = self.statistics(*common, "--receiver", "far.obj")
        self.assertLessEqual(near["maximumShadowDeviation"], 1e-3)
        self.assertLessEqual(both["maximumShadowDeviation"], 1e-3)
        self.assertGreater(near["maximumShadowDeviation"], near["maximumDeviation"])
        self.assertGreater(both["points"], near["points"])

    def test_search(self):
        statistics = {}
        for search in ("automatic", "brute-force", "hierarchy", "tracking", "randomized"):
            statistics[search] = self.statistics(
                "silhouette", BUNNY, "-o", search + ".vtp", "--light", "-2,3,4", "--search", search)
        everything = statistics["brute-force"]
        self.assertTrue(everything["searchComplete"])
        for search in ("automatic", "hierarchy"):
            self.assertTrue(statistics[search]["searchComplete"])
            self.assertEqual(statistics[search]["points"], everything["points"])
            self.assertLess(statistics[search]["edgesTested"], 0.5 * everything["edgesTested"])
        for search in ("tracking", "randomized"):
            self.assertFalse(statistics[search]["searchComplete"])
            self.assertGreater(statistics[search]["loops"], 0)
            self.assertLessEqual(statistics[search]["points"], everything["points"])
        common = ("silhouette", BUNNY, "-o", "out.vtp", "--light", "-2,3,4", "--search",
                  "randomized")
        few = self.statistics(*common, "--sample-fraction", "1e-4")
        again = self.statistics(*common, "--sample-fraction", "1e-4", "--seed", "2")
        all_of_it = self.statistics(*common, "--sample-fraction", "1")
        self.assertLess(few["points"], all_of_it["points"])
        self.assertNotEqual(few["points"], again["points"])
        self.assertTrue(all_of_it["searchComplete"])

    def test_strips(self):
        common = ("volume", BUNNY, "-o", "out.vtp", "--light", "-2,3,4")
        plain = self.statistics(*common)
        strips = self.statistics(*common, "--strips")
        volume = Meshes.read_polydata(self.path("out.vtp"))
        self.assertEqual(plain["strips"], 0)
        self.assertEqual(strips["strips"], volume.GetNumberOfStrips())
        self.assertGreater(volume.GetNumberOfStrips(), 3)
        self.assertLess(strips["triangles"]["wall"], 0.2 * plain["triangles"]["wall"])
        self.assertTrue(strips["closed"])

    def test_output_is_binary(self):
        Meshes.write_sphere(self.path("sphere.vtp"))
        self.succeed("silhouette", "sphere.vtp", "-o", "out.vtp", "--light", "1,2,3")
        with open(self.path("out.vtp"), "rb") as file:
            self.assertIn(b'<AppendedData encoding="raw">', file.read())

    def test_volume(self):
        for kind in ("discrete", "accurate", "smooth"):
            with self.subTest(kind):
                statistics = self.statistics(
                    "volume", BUNNY, "-o", "out.vtp", "--light", "-2,3,4", "--kind", kind)
                volume = Meshes.read_polydata(self.path("out.vtp"))
                triangles = statistics["triangles"]
                parts = volume.GetCellData().GetArray("Part")
                counts = [0, 0, 0, 0]
                for i in range(parts.GetNumberOfValues()):
                    counts[int(parts.GetValue(i))] += 1
                self.assertEqual([triangles[part] for part in ("cap", "gap", "wall", "farCap")],
                                 counts)
                self.assertEqual(triangles["all"], volume.GetNumberOfPolys())
                self.assertGreater(triangles["wall"], 1000)
                self.assertTrue(statistics["closed"])
                homogeneous = volume.GetPointData().GetArray("Homogeneous")
                self.assertEqual(homogeneous.GetDataTypeAsString(), "double")

    def test_caps(self):
        Meshes.write_sphere(self.path("sphere.vtp"))
        common = ("volume", "sphere.vtp", "-o", "out.vtp", "--light", "1,2,3", "--kind", "discrete")
        counts = {caps: self.statistics(*common, "--caps", caps)["triangles"]["cap"]
                  for caps in ("automatic", "lit", "dark", "none")}
        self.assertEqual(counts["automatic"], counts["dark"])
        self.assertEqual(counts["lit"] + counts["dark"], Meshes.SPHERE_TRIANGLES)
        self.assertEqual(counts["none"], 0)

    def test_length(self):
        Meshes.write_sphere(self.path("sphere.vtp"))
        self.succeed("volume", "sphere.vtp", "-o", "out.vtp", "--light", "0,0,1,0", "--length",
                     "7", "--kind", "discrete")
        bounds = Meshes.read_polydata(self.path("out.vtp")).GetBounds()
        self.assertLess(bounds[4], -6.4)
        self.assertGreater(bounds[4], -7.6)

    def test_extent(self):
        Meshes.write_sphere(self.path("sphere.vtp"))
        common = ("volume", "sphere.vtp", "-o", "out.vtp", "--light", "0,0,1,0", "--caps", "lit")
        self.assertIsNone(self.statistics(*common)["volume"])
        # A column, and on the plane half a ball above it.
        length = self.statistics(*common, "--extent", "length", "--length", "3")["volume"]
        plane = self.statistics(*common, "--extent", "plane", "--plane-origin", "0,0,-3",
                                "--plane-normal", "0,0,5")["volume"]
        radius = Meshes.read_polydata(self.path("sphere.vtp")).GetBounds()[1]
        area = math.pi * radius ** 2
        self.assertAlmostEqual(length / (3 * area), 1, delta=0.1)
        self.assertAlmostEqual(plane / (3 * area + 2 / 3 * area * radius), 1, delta=0.1)
        bounds = Meshes.read_polydata(self.path("out.vtp")).GetBounds()
        self.assertAlmostEqual(bounds[4], -3)
        self.fail_in("sphere.vtp", "do not come to the plane", *common, "--extent", "plane",
                     "--plane-origin", "0,0,-3", "--plane-normal", "1,0,0")

    def test_without_json_a_line_for_people(self):
        Meshes.write_sphere(self.path("sphere.vtp"))
        line = self.succeed("silhouette", "sphere.vtp", "-o", "out.vtp", "--light", "1,2,3")
        self.assertRegex(line, r"\Aout\.vtp: \d+ loops, \d+ points, .*\n\Z")


class Contour(ToolTest):
    """A box of height 2 on the ground y = 0, with a smaller one in its shadow. Towards the light is
    (1, 2, -1): the shadow of the box's top is its base, moved by (-1, 1) in x and z."""
    LIGHT = ("--light", "1,2,-1,0")
    ABOVE = ("--parallel", "--eye", "0,9,0", "--at", "0,0,0")
    SHADOW = [(0, 0), (-1, 1), (-1, 2), (0, 2), (1, 1)]

    def setUp(self):
        super().setUp()
        Meshes.write_box(self.path("box.obj"), (0, 0, 0), (1, 2, 1))
        Meshes.write_box(self.path("small.obj"), (-0.5, 0.5, 0.7), (-0.3, 0.6, 0.9))
        Meshes.write_ground(self.path("ground.obj"), 5)

    def contour(self, output, *options, casters=("box.obj",), receivers=("ground.obj",)):
        return self.statistics("contour", "--caster", *casters, "--receiver", *receivers,
                               "-o", output, *self.LIGHT, *options)

    def draw(self, *options, **meshes):
        statistics = self.contour("out.svg", *options, **meshes)
        return statistics, Meshes.Drawing(self.path("out.svg"))

    def assert_points(self, piece, wanted, delta=1e-6):
        """Each wanted point is one of the piece, and each of the piece on a side between two."""
        self.assertGreaterEqual(len(piece), len(wanted))
        for point in wanted:
            self.assertLess(min(math.dist(point, other) for other in piece), delta, point)
        for point in piece:
            self.assertLess(min(math.dist(point, a) + math.dist(point, b) - math.dist(a, b)
                                for a, b in zip(wanted, wanted[1:])), delta, point)

    def test_vtp(self):
        for builder in ("unsorted", "object-median", "morton"):
            statistics = self.contour("out.vtp", "--builder", builder, "--repeat", "2")
            lines = Meshes.read_polydata(self.path("out.vtp"))
            self.assertEqual(statistics["builder"], builder)
            self.assertEqual((statistics["lines"], statistics["hiddenLines"]), (1, 0))
            self.assertEqual(lines.GetNumberOfLines(), 1)
            self.assertEqual(statistics["points"], lines.GetNumberOfPoints())
            self.assertEqual(statistics["looseEnds"], 0)
            self.assertGreater(statistics["leavesTested"], 0)
            self.assertGreater(statistics["milliseconds"], 0)
            self.assertEqual(statistics["casters"][0]["boundaryEdges"], 0)
            self.assertEqual(statistics["receivers"][0]["polygons"], 1)
            self.assertNotIn("drawing", statistics)
            points = [lines.GetPoint(i) for i in range(lines.GetNumberOfPoints())]
            self.assertEqual({y for _, y, _ in points}, {0})
            self.assert_points([(x, z) for x, _, z in points], self.SHADOW)

    def test_builders(self):
        found = [self.contour("out.vtp", "--builder", builder, casters=(BUNNY,),
                              receivers=(BUNNY,))
                 for builder in ("unsorted", "object-median", "morton")]
        self.assertGreater(found[0]["leavesTested"], 1000)
        for name in ("lines", "points", "leavesTested"):
            self.assertEqual(len({statistics[name] for statistics in found}), 1, name)
        self.assertEqual(len({statistics["nodesVisited"] for statistics in found}), 3)

    def test_hidden_contours(self):
        casters = ("box.obj", "small.obj")
        shown = self.contour("out.vtp", "--kind", "discrete", casters=casters)
        self.assertEqual((shown["lines"], shown["hiddenLines"]), (1, 0))
        kept = self.contour("out.vtp", "--kind", "discrete", "--keep-hidden", casters=casters)
        self.assertEqual((kept["lines"], kept["hiddenLines"]), (2, 1))
        visible = Meshes.read_polydata(self.path("out.vtp")).GetCellData().GetArray("Visible")
        self.assertEqual({visible.GetValue(0), visible.GetValue(1)}, {0, 1})

    def test_drawing_to_scale(self):
        statistics, drawing = self.draw("--keep-hidden", "--scale", "20", "--kind", "discrete",
                                        *self.ABOVE, casters=("box.obj", "small.obj"))
        height = 2 * 9 * math.tan(math.radians(15))
        left, top, width, shown = drawing.view
        self.assertAlmostEqual(shown, height, 6)
        self.assertAlmostEqual(width, height * 4 / 3, 6)
        self.assertAlmostEqual(left, -width / 2, 6)
        self.assertAlmostEqual(top, -height / 2, 6)
        self.assertEqual(drawing.width[-2:] + drawing.height[-2:], "mmmm")
        self.assertAlmostEqual(float(drawing.width[:-2]), 20 * width, 5)
        self.assertAlmostEqual(float(drawing.height[:-2]), 20 * height, 5)
        self.assertEqual(list(drawing.layers), ["hidden-contours", "contours"])
        self.assertEqual(drawing.labels["contours"], "Shadow contours")
        # From above x is to the right and z downwards. Its ends are under walls of the box: what
        # is seen begins there up to the last halving of a step.
        path, = drawing.layers["contours"]
        piece, = path
        self.assert_points(piece, self.SHADOW, delta=5e-6)
        # Below the small box, of which half hides its own shadow.
        hidden, = drawing.layers["hidden-contours"]
        for x, y in (point for piece in hidden for point in piece):
            self.assertTrue(-0.8 - 1e-6 < x < -0.55 + 1e-6 and 0.95 - 1e-6 < y < 1.2 + 1e-6)
        self.assertEqual(statistics["drawing"]["paths"], {"hidden-contours": 1, "contours": 1})

    def test_drawing_in_perspective(self):
        statistics, drawing = self.draw("--eye", "-4,3,8", "--at", "0,1,0", "--size", "300x200",
                                        "--angle", "40")
        self.assertEqual((drawing.width, drawing.height), ("300", "200"))
        self.assertEqual(statistics["drawing"]["camera"],
                         {"eye": [-4, 3, 8], "at": [0, 1, 0], "up": [0, 1, 0], "angle": 40})
        forward = (4, -2, -8)
        distance = math.hypot(*forward)
        forward = [c / distance for c in forward]
        level = math.hypot(forward[0], forward[2])
        right = (-forward[2] / level, 0, forward[0] / level)
        up = (-forward[1] * forward[0] / level, level, -forward[1] * forward[2] / level)
        self.assertAlmostEqual(drawing.view[3], 2 * distance * math.tan(math.radians(20)), 5)

        def project(x, z):
            ray = (x + 4, -3, z - 8)
            along, across, upwards = (sum(a * b for a, b in zip(axis, ray))
                                      for axis in (forward, right, up))
            return distance * across / along, -distance * upwards / along
        # Nothing is before it.
        path, = drawing.layers["contours"]
        piece, = path
        self.assert_points(piece, [project(x, z) for x, z in self.SHADOW])

    def test_what_is_behind_is_not_drawn(self):
        _, drawing = self.draw("--parallel", "--eye", "0.5,20,-20", "--at", "0.5,0,0")
        path, = drawing.layers["contours"]
        # Seen from above at 45 degrees the box covers the ground up to z = 3, for x from 0 to 1.
        self.assertGreater(len(path[0]), 2)
        for x, _ in path[0]:
            self.assertGreaterEqual(x, 0.5 - 1e-4)  # x = 0, to the right of the middle

    def test_outlines_and_creases(self):
        statistics, drawing = self.draw("--outlines", "--eye", "0.5,9,0.5", "--at", "0.5,0,0.5")
        self.assertEqual(list(drawing.layers), ["hidden-contours", "contours", "creases",
                                                "outlines"])
        self.assertEqual(statistics["drawing"]["paths"]["creases"], len(drawing.layers["creases"]))
        # The box's top is nearer, and hides all else of it.
        top = 0.5 * 9 / 7
        for layer in ("creases", "outlines"):
            pieces = [piece for path in drawing.layers[layer] for piece in path]
            points = [point for piece in pieces for point in piece]
            for corner in ((-top, -top), (top, -top), (top, top), (-top, top),
                           (-5.5, -5.5), (4.5, -5.5), (4.5, 4.5), (-5.5, 4.5)):
                self.assertLess(min(math.dist(corner, point) for point in points), 1e-5)
            for x, y in points:
                onTop = max(abs(x), abs(y)) < 2
                sides = (top - abs(x), top - abs(y)) if onTop else \
                    (x + 5.5, y + 5.5, 4.5 - x, 4.5 - y)
                # Nothing hides a line from what is nearer to it than 1e-5 of the scene's size.
                self.assertAlmostEqual(min(sides), 0, delta=5e-5)

    def test_round_outline(self):
        Meshes.write_sphere(self.path("sphere.vtp"))
        _, drawing = self.draw("--outlines", "--parallel", "--eye", "1,9,2", "--at", "0,0,0",
                               casters=("sphere.vtp",))
        # That of the smooth surface; a part of it is behind the ground.
        pieces = [piece for path in drawing.layers["outlines"] for piece in path
                  if max(map(math.hypot, *zip(*piece))) < 2]
        length = 0
        for piece in pieces:
            for x, y in piece:
                self.assertAlmostEqual(math.hypot(x, y), 0.5, delta=5e-3)
            length += sum(math.dist(a, b) for a, b in zip(piece, piece[1:]))
        self.assertAlmostEqual(length, math.pi / 2, delta=0.05)

    def test_outlines_and_shadow_of_a_torus(self):
        # Seen from above it is a ring, of which the mesh's triangles hide a part of the inner
        # circle; its shadow is beside it.
        Meshes.write_torus(self.path("torus.vtp"), height=4)
        statistics = self.statistics(
            "contour", "--caster", "torus.vtp", "--receiver", "ground.obj", "-o", "out.svg",
            "--light", "0.7,0.9,0.5,0", "--outlines", "--parallel", "--eye", "0,90,0", "--at",
            "0,0,0", "--angle", "7")
        drawing = Meshes.Drawing(self.path("out.svg"))
        for radius in (0.6, 1.4):
            pieces = [piece for path in drawing.layers["outlines"] for piece in path
                      if max(abs(math.hypot(*point) - radius) for point in piece) < 0.01]
            length = sum(math.dist(a, b) for piece in pieces for a, b in zip(piece, piece[1:]))
            self.assertAlmostEqual(length / (2 * math.pi * radius), 1, delta=0.01)
        self.assertEqual((statistics["lines"], len(drawing.layers["contours"])), (2, 2))
        for path in drawing.layers["contours"]:
            piece, = path
            self.assertEqual(piece[0], piece[-1])
            self.assertGreater(len(piece), 20)

    def test_same_mesh_casts_and_receives(self):
        statistics = self.contour("out.vtp", casters=(BUNNY,), receivers=("ground.obj", BUNNY))
        receivers = Meshes.read_polydata(self.path("out.vtp")).GetCellData().GetArray("Receiver")
        self.assertEqual({receivers.GetValue(i) for i in range(statistics["lines"])}, {0, 1})

    def test_regions(self):
        for kind in ("discrete", "smooth"):
            statistics = self.contour("out.svg", "--regions", "regions.vtp", "--kind", kind,
                                      receivers=("ground.obj", "box.obj"))
            self.assertEqual(statistics["regions"], "regions.vtp")
            ground, box = statistics["receivers"]
            # The hexagon around SHADOW and what the box stands on.
            self.assertAlmostEqual(ground["shadowedArea"], 3, delta=1e-6)
            self.assertAlmostEqual(ground["litArea"], 97, delta=1e-6)
            self.assertEqual((ground["turnedAwayArea"], box["shadowedArea"]), (0, 0))
            self.assertAlmostEqual(box["litArea"] + box["turnedAwayArea"], 10)
            regions = Meshes.read_polydata(self.path("regions.vtp"))
            self.assertEqual(regions.GetNumberOfPolys(), statistics["regionPolygons"])
            lit = regions.GetCellData().GetArray("Lit")
            self.assertEqual({lit.GetValue(i) for i in range(regions.GetNumberOfPolys())}, {0, 1})
            area = regions.GetFieldData().GetArray("ShadowedArea")
            self.assertEqual(area.GetValue(0), ground["shadowedArea"])
        self.assertNotIn("regions", self.contour("out.svg"))

    def test_light_on_a_caster(self):
        self.fail_in("ground.obj", "lies on a silhouette", "contour", "--caster", "ground.obj",
                     "--receiver", "box.obj", "-o", "out.svg", "--light", "5,0,0.5")

    def test_the_caster_at_fault_is_named(self):
        # In the plane of its own silhouette there is no light.
        for order in (("box.obj", "ground.obj"), ("ground.obj", "box.obj")):
            message = self.fail_with(1, "contour", "--caster", *order, "--receiver", "box.obj",
                                     "-o", "out.svg", "--light", "5,0,0.5")
            self.assertRegex(message, r"lies on a silhouette.*\), in ground\.obj, check it and "
                             r"--light 5,0,0\.5,1\n")

    def test_the_mesh_that_is_too_large_is_named(self):
        Meshes.write_torus(self.path("large.vtp"), radius=1e300, tube=4e299)
        for caster, receiver in (("box.obj", "large.vtp"), ("large.vtp", "box.obj")):
            self.fail_in("large.vtp", "too large for a view", "contour", "--caster", caster,
                         "--receiver", receiver, "-o", "out.svg", *self.LIGHT)

    def test_a_sheet_without_size_is_refused(self):
        # A sheet of some 5 units, and one of 2e-5.
        for scale, at, angle, wanted in (("1e308", "0,0,0", "30", "smaller"),
                                         ("5e-324", "0,8.999,0", "1", "larger")):
            message = self.fail_with(2, "contour", "--caster", "box.obj", "--receiver",
                                     "ground.obj", "-o", "out.svg", *self.LIGHT, "--eye", "0,9,0",
                                     "--at", at, "--angle", angle, "--scale", scale)
            self.assertIn(f"--scale {scale}: ", message)
            self.assertIn(f"a {wanted} scale", message)

    def test_what_is_behind_the_eye_or_far_from_the_sheet_is_cut_off(self):
        # Looking along z, x is to the left: the shadow's sides from (-1, 1) to (-1, 2) and from
        # (0, 2) to (1, 1) in x and z begin behind the eye and end before it. The sheet is 2 high
        # and 4 wide, and is drawn on up to 3 times that.
        _, drawing = self.draw("--kind", "discrete", "--eye", "-0.5,0.25,1.5", "--at",
                               "-0.5,0.25,2.5", "--angle", "90", "--size", "400x200")
        points = [point for path in drawing.layers["contours"] for piece in path
                  for point in piece]
        self.assertEqual(len(points), 4)
        # The eye is a quarter above the ground. One side is cut at the bottom, y = 3, at the depth
        # of 1/12, the other one at the right, x = -6, where (1 - depth) / depth = 6.
        for x, depth in (-1, 1 / 12), (-1, 0.5), (0, 0.5), (0.5 - 1 / 7, 1 / 7):
            wanted = (-(x + 0.5) / depth, 0.25 / depth)
            self.assertLess(min(math.dist(wanted, point) for point in points), 1e-6, wanted)
        for x, y in points:
            self.assertLessEqual(abs(x), 6 + 1e-6)
            self.assertLessEqual(abs(y), 3 + 1e-6)
        # In parallel projection, from above, the shadow's side at z = 2 is outside, and the contour
        # comes back in.
        _, drawing = self.draw("--parallel", "--eye", "0,9,0", "--at", "0,7.5,0")
        edge = 1.5 * 2 * 1.5 * math.tan(math.radians(15))
        path, = drawing.layers["contours"]
        self.assertEqual(len(path), 2)
        points = [point for piece in path for point in piece]
        for wanted in (0, 0), (-1, 1), (-1, edge), (2 - edge, edge), (1, 1):
            self.assertLess(min(math.dist(wanted, point) for point in points), 1e-5, wanted)
        self.assertLessEqual(max(y for _, y in points), edge + 1e-6)

    def test_repeats_exactly_and_without_dots(self):
        texts = []
        for _ in range(2):
            _, drawing = self.draw("--outlines", casters=(BUNNY,))
            with open(self.path("out.svg"), "rb") as file:
                texts.append(file.read())
        self.assertGreater(len(texts[0]), 10000)
        self.assertEqual(texts[0], texts[1])
        lengths = [sum(map(math.dist, piece, piece[1:]))
                   for paths in drawing.layers.values() for path in paths for piece in path]
        self.assertGreater(len(lengths), 20)
        self.assertGreater(min(lengths), 0.999e-3 * drawing.view[3])

    def test_without_json_a_line_for_people(self):
        line = self.succeed("contour", "--caster", "box.obj", "--receiver", "ground.obj", "-o",
                            "out.svg", *self.LIGHT)
        self.assertRegex(line, r"\Aout\.svg: 1 contours, \d+ points, [0-9.e-]+ ms a light move\n\Z")


class Check(ToolTest):
    """Defects are found, not failed at."""

    def defects(self, statistics):
        return {defect["defect"]: defect["count"] for defect in statistics["defects"]}

    def open_tetrahedron(self):
        return Meshes.write_obj(self.path("open.obj"), [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
                                [(0, 2, 1), (0, 1, 3), (1, 2, 3)])

    def test_bunny(self):
        statistics = self.statistics("check", BUNNY)
        self.assertEqual(statistics["command"], "check")
        self.assertEqual(statistics["mesh"]["file"], BUNNY)
        self.assertEqual(statistics["mesh"]["triangles"], BUNNY_TRIANGLES)
        # Euler's formula on a surface without handles.
        self.assertEqual(statistics["mesh"]["distinctPoints"], BUNNY_TRIANGLES // 2 + 2)
        self.assertEqual((statistics["mesh"]["parts"], statistics["mesh"]["closedParts"]), (1, 1))
        self.assertTrue(statistics["mesh"]["closed"])
        self.assertEqual(statistics["shadow"], "well defined")
        self.assertTrue(statistics["intersectionsChecked"])
        defects = self.defects(statistics)
        self.assertGreater(defects.pop("averaged normals"), 0)
        self.assertGreater(defects.pop("estimated normals"), BUNNY_TRIANGLES // 2)
        self.assertEqual(defects, {"slivers": 4, "pierced triangles": 3})
        meanings = {d["defect"]: d["meaning"] for d in statistics["defects"]}
        self.assertEqual(meanings["pierced triangles"], "well defined")
        fewer = self.statistics("check", BUNNY, "--no-intersections")
        self.assertFalse(fewer["intersectionsChecked"])
        self.assertNotIn("pierced triangles", self.defects(fewer))

    def test_clean_mesh(self):
        Meshes.write_sphere(self.path("sphere.vtp"))
        statistics = self.statistics("check", "sphere.vtp")
        self.assertEqual((statistics["shadow"], statistics["defects"]), ("exact", []))
        self.assertEqual(self.succeed("check", "sphere.vtp"),
                         f"sphere.vtp: {Meshes.SPHERE_TRIANGLES} triangles, 86 distinct points, 1 "
                         "part, closed\n\nNo defects. Its discrete shadow is exact.\n")

    def test_open_mesh(self):
        mesh = self.open_tetrahedron()
        statistics = self.statistics("check", mesh)
        self.assertFalse(statistics["mesh"]["closed"])
        self.assertEqual(statistics["mesh"]["twoSidedTriangles"], 3)
        border = next(d for d in statistics["defects"] if d["defect"] == "border edges")
        self.assertEqual((border["count"], border["meaning"]), (3, "exact"))
        self.assertEqual(border["place"], [0, 0, 0.5])
        self.assertTrue(border["shadow"] and border["remedy"])
        text = self.succeed("check", mesh)
        self.assertIn("not closed, both sides of 3 triangles cast", " ".join(text.split()))
        self.assertRegex(text, r"\n +3  border edges +exact +at 0, 0, 0\.5\n")
        self.assertTrue(text.endswith("above.\n"), text)
        self.assertRegex(text, r"\n +\d+  estimated normals  well defined\n")  # without a place
        self.assertNotRegex(text, r" \n")

    def test_wrapped_to_100_columns(self):
        lines = self.succeed("check", self.open_tetrahedron()).splitlines()
        self.assertLessEqual(max(map(len, lines)), 100)
        self.assertGreater(max(map(len, lines)), 80)

    def test_wrapped_to_the_terminal(self):
        try:
            leader, follower = pty.openpty()
        except OSError as error:
            self.skipTest(f"no terminal to be had here: {error}")
        fcntl.ioctl(follower, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 60, 0, 0))
        run = subprocess.run([TOOL, "check", self.open_tetrahedron()], cwd=self.folder,
                             stdout=follower, stderr=subprocess.PIPE, timeout=60)
        os.close(follower)
        lines = os.read(leader, 65536).decode().splitlines()
        os.close(leader)
        self.assertEqual((run.returncode, run.stderr), (0, b""))
        sentences = [len(line) for line in lines if line.startswith(" " * 10)]
        self.assertGreater(len(sentences), 5)
        self.assertLessEqual(max(sentences), 60)

    def test_non_finite_points_are_warned_of(self):
        mesh = self.path("mesh.vtp")
        touched = Meshes.write_broken_sphere(mesh, math.nan, point=40)
        statistics = self.statistics("check", mesh)
        self.assertEqual(statistics["shadow"], "warned")
        self.assertEqual(statistics["defects"][0]["defect"], "non-finite cells")
        self.assertEqual(statistics["defects"][0]["count"], touched)
        self.assertRegex(self.succeed("check", mesh), r"\nSome of its shadow is missing.*\n\Z")
        touched = Meshes.write_broken_sphere(mesh, math.nan)
        statistics = self.statistics("check", mesh)
        self.assertEqual(self.defects(statistics)["no triangles"], 1)
        self.assertFalse(statistics["mesh"]["closed"])
        self.assertIsNone(statistics["defects"][0]["place"])

    def test_lines_are_seen(self):
        with open(self.path("mesh.vtk"), "w") as file:
            file.write("# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 5 double\n"
                       "0 0 0 1 0 0 0 1 0 5 5 5 6 6 6\nPOLYGONS 1 4\n3 0 1 2\nLINES 1 3\n2 3 4\n")
        statistics = self.statistics("check", "mesh.vtk")
        self.assertEqual(self.defects(statistics)["lines and vertices"], 1)
        self.assertNotIn("unused points", self.defects(statistics))

    def test_feature_angle_splits_edges(self):
        Meshes.write_tetrahedron(self.path("mesh.obj"))
        counts = [self.defects(self.statistics("check", "mesh.obj", "--feature-angle", angle))
                  ["estimated normals"] for angle in ("60", "180")]
        self.assertEqual(counts, [12, 4])


class WrongUsage(ToolTest):
    RENDER = ("render", "mesh.obj", "-o", "out.png")
    SILHOUETTE = ("silhouette", "mesh.obj", "-o", "out.vtp", "--light", "1,2,3")
    VOLUME = ("volume", "mesh.obj", "-o", "out.vtp", "--light", "1,2,3")

    CONTOUR = ("contour", "--caster", "mesh.obj", "--receiver", "mesh.obj", "-o", "out.vtp",
               "--light", "1,2,3")

    def test_messages_name_option_and_value(self):
        Meshes.write_tetrahedron(self.path("mesh.obj"))
        cases = [
            ((), "subcommand"),
            (("paint", "mesh.obj"), "paint: no such command"),
            (("render",), "required"),
            (("render", "mesh.obj"), "--output"),
            (("render", "mesh.obj", "-o", "out.jpg"), "--output out.jpg"),
            (("silhouette", "mesh.obj", "-o", "out.png", "--light", "1,2,3"), "--output out.png"),
            (("silhouette", "mesh.obj", "-o", "out.vtp"), "--light"),
            ((*self.CONTOUR, "--regions", "out.svg"), "--regions out.svg"),
            ((*self.CONTOUR, "--regions", "./out.vtp"), "--regions ./out.vtp: it is the --output"),
            ((*self.RENDER, "--light", "nan,0,0"), "--light nan,0,0: 'nan' is not finite"),
            ((*self.RENDER, "--light", "-inf,0,0"), "--light -inf,0,0: '-inf' is not finite"),
            ((*self.RENDER, "--light", "1e999,0,0"), "1e999"),
            ((*self.RENDER, "--light", "0,0,0,0"), "--light 0,0,0,0"),
            ((*self.RENDER, "--light", "1,2"), "--light 1,2"),
            ((*self.RENDER, "--light", "1,2,3,4,5"), "--light 1,2,3,4,5"),
            ((*self.RENDER, "--light", "1,2,x"), "'x' is not a number"),
            ((*self.RENDER, "--light", "1,2,"), "'' is not a number"),
            ((*self.RENDER, "--light", "1e300,0,0,1e-300"), "1e300,0,0,1e-300"),
            ((*self.RENDER, "--light"), "--light"),
            ((*self.RENDER, "--eye", "1,nan,2"), "--eye 1,nan,2"),
            ((*self.RENDER, "--up", "0,0,0"), "--up 0,0,0"),
            ((*self.RENDER, "--angle", "180"), "--angle 180"),
            ((*self.RENDER, "--angle", "-3"), "--angle -3"),
            ((*self.RENDER, "--size", "640"), "--size 640"),
            ((*self.RENDER, "--size", "0x480"), "--size 0"),
            ((*self.RENDER, "--size", "99999x480"), "99999"),
            ((*self.RENDER, "--supersample", "0"), "--supersample 0"),
            ((*self.RENDER, "--size", "9000x9000", "--supersample", "2"), "--supersample 2"),
            ((*self.RENDER, "--frames", "-1"), "--frames -1"),
            ((*self.RENDER, "--kind", "soft"), "soft"),
            ((*self.RENDER, "--window", "x11"), "x11"),
            ((*self.RENDER, "--mask", "mask.tif"), "--mask mask.tif"),
            ((*self.RENDER, "--shiny"), "--shiny"),
            ((*self.SILHOUETTE, "--kind", "none"), "none"),
            ((*self.SILHOUETTE, "--tolerance", "0"), "--tolerance 0"),
            ((*self.SILHOUETTE, "--tolerance", "nan"), "--tolerance nan"),
            ((*self.SILHOUETTE, "--tolerance-mode", "pixels"), "pixels"),
            ((*self.SILHOUETTE, "--feature-angle", "181"), "--feature-angle 181"),
            ((*self.SILHOUETTE, "--tolerance-mode", "receiver"), "--receiver"),
            ((*self.SILHOUETTE, "--receiver", "ground.obj"), "--receiver ground.obj"),
            ((*self.SILHOUETTE, "--search", "guess"), "guess"),
            ((*self.SILHOUETTE, "--sample-fraction", "1.5"), "--sample-fraction 1.5"),
            ((*self.SILHOUETTE, "--sample-fraction", "nan"), "--sample-fraction nan"),
            ((*self.SILHOUETTE, "--seed", "0"), "--seed 0"),
            ((*self.SILHOUETTE, "second.obj"), "second.obj"),
            ((*self.VOLUME, "--caps", "far"), "far"),
            ((*self.VOLUME, "--length", "-1"), "--length -1"),
            ((*self.VOLUME, "--extent", "far"), "far"),
            ((*self.VOLUME, "--plane-origin", "1,2"), "--plane-origin 1,2"),
            ((*self.VOLUME, "--plane-normal", "0,0,0"), "--plane-normal 0,0,0"),
            (("contour", "--receiver", "mesh.obj", "-o", "out.vtp", "--light", "1,2,3"), "--caster"),
            (("contour", "--caster", "mesh.obj", "-o", "out.vtp", "--light", "1,2,3"),
             "--receiver"),
            (self.CONTOUR[:-4], "--output"),
            (self.CONTOUR[:-2], "--light"),
            ((*self.CONTOUR[:-3], "out.png", "--light", "1,2,3"), ".vtp or .svg"),
            ((*self.CONTOUR, "--builder", "guess"), "guess"),
            ((*self.CONTOUR, "--kind", "none"), "none"),
            ((*self.CONTOUR, "--outlines"), "--outlines"),
            ((*self.CONTOUR, "--eye", "1,2,3"), "--eye"),
            ((*self.CONTOUR, "--scale", "0"), "--scale 0"),
            ((*self.CONTOUR, "--angle", "180"), "--angle 180"),
            (("check",), "mesh"),
            (("check", "mesh.obj", "second.obj"), "second.obj"),
            (("check", "mesh.obj", "--light", "1,2,3"), "--light"),
            (("check", "mesh.obj", "--feature-angle", "181"), "--feature-angle 181"),
        ]
        for arguments, named in cases:
            with self.subTest(arguments):
                message = self.fail_with(2, *arguments)
                self.assertIn(named, message)

    def test_help(self):
        for command, named in ((), "silhouette"), (("render",), "--mask"), \
                (("silhouette",), "--tolerance"), (("volume",), "--caps"), \
                (("contour",), "--keep-hidden"), (("check",), "--no-intersections"):
            self.assertIn(named, self.succeed(*command, "--help"))


class BadInput(ToolTest):
    def refuse(self, file, what):
        """By every command."""
        light = ("--light", "1,2,3")
        self.fail_in(file, what, "render", file, "-o", "out.png", "--ground", "--mask", "mask.png")
        self.fail_in(file, what, "silhouette", file, "-o", "out.vtp", *light)
        self.fail_in(file, what, "volume", file, "-o", "out.vtp", *light, "--json")
        self.fail_in(file, what, "check", file)
        if os.path.exists(self.path(file)):
            Meshes.write_sphere(self.path("good.vtp"))
        for meshes in (("--caster", file, "--receiver", file),
                       ("--caster", "good.vtp", "--receiver", file)):
            if meshes[1] == file or os.path.exists(self.path("good.vtp")):
                self.fail_in(file, what, "contour", *meshes, "-o", "out.svg", *light)

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content)
        return name

    def test_missing(self):
        self.refuse("missing.ply", "no such file")

    def test_folder(self):
        os.mkdir(self.path("folder.ply"))
        self.refuse("folder.ply", "folder")

    def test_unknown_format(self):
        self.refuse(self.write("mesh.docx", b"PK"), "format")

    def test_empty(self):
        for extension in ("ply", "stl", "obj", "vtk", "vtp", "gltf", "glb", "3ds"):
            with self.subTest(extension):
                self.refuse(self.write("empty." + extension, b""), "empty")

    def test_not_a_mesh(self):
        contents = (b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 20, b"Dear reader,\nno mesh.\n" * 50)
        for extension in ("ply", "stl", "obj", "vtk", "vtp", "gltf", "glb", "3ds"):
            for content in contents:
                with self.subTest(extension=extension, content=content[:4]):
                    self.refuse(self.write("letter." + extension, content), "")

    def test_second_mesh_of_two(self):
        Meshes.write_sphere(self.path("good.ply"))
        self.fail_in("missing.ply", "no such file", "render", "good.ply", "missing.ply", "-o",
                     "out.png")

    def test_cut_short(self):
        for extension in ("ply", "stl", "vtk", "vtp", "gltf"):
            for binary in (False, True):
                mesh = Meshes.write_sphere(self.path("whole." + extension), binary)
                with open(mesh, "rb") as file:
                    whole = file.read()
                os.remove(mesh)
                for part in (0.02, 0.3, 0.6, 0.9):
                    with self.subTest(extension=extension, binary=binary, part=part):
                        cut = self.write("cut." + extension, whole[:int(part * len(whole))])
                        self.fail_in(cut, "", "silhouette", cut, "-o", "out.vtp", "--light",
                                     "1,2,3")

    def test_obj_cut_short(self):
        # Before the first face, and within a face; between two faces nothing shows.
        with open(BUNNY, "rb") as file:
            whole = file.read()
        face = whole.rindex(b"f ")
        for end in (100000, whole.index(b"f ") - 1, face + 3):
            with self.subTest(end):
                cut = self.write("cut.obj", whole[:end])
                self.fail_in(cut, "", "silhouette", cut, "-o", "out.vtp", "--light", "1,2,3")

    def test_faces_without_their_points(self):
        mesh = self.write("mesh.vtk", b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n"
                          b"POINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 7\n")
        self.refuse(mesh, "point 7 of 3")
        header = (b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                  b"property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                  b"end_header\n0 0 0\n1 0 0\n0 1 0\n")
        self.refuse(self.write("mesh.ply", header + b"3 0 1 -2\n"), "point -2 of 3")

    def test_no_polygon(self):
        self.refuse(self.write("points.obj", b"v 0 0 0\nv 1 0 0\nl 1 2\n"), "no polygon")

    def test_broken_ply_headers(self):
        for content in (b"ply\n", b"ply\nformat ascii 1.0\nelement\nend_header\n",
                        b"ply\nformat ascii 1.0\nelement vertex many\nend_header\n",
                        b"ply\nformat ascii 1.0\nelement vertex 1\nproperty\nend_header\n0\n",
                        b"ply\nformat ascii 1.0\nelement vertex 1\nproperty vec x\nend_header\n0\n",
                        b"ply\nformat ascii 1.0\nproperty float x\nend_header\n",
                        b"ply\nelement vertex 1\nproperty float x\nend_header\n0\n",
                        b"ply\nformat base64 1.0\nelement vertex 0\nend_header\n"):
            with self.subTest(content):
                self.refuse(self.write("mesh.ply", content), "PLY")


class NonFinitePoints(ToolTest):
    """What is finite of a mesh still casts; what is not is counted."""

    def test_one_point(self):
        mesh = self.path("mesh.vtp")
        for value in (math.nan, math.inf, -math.inf):
            with self.subTest(value):
                touched = Meshes.write_broken_sphere(mesh, value, point=40)
                self.assertGreater(touched, 3)
                statistics = self.statistics(
                    "silhouette", mesh, "-o", "out.vtp", "--light", "2,3,4")
                self.assertEqual(statistics["mesh"]["nonFiniteCells"], touched)
                self.assertGreater(statistics["loops"], 0)
                statistics = self.statistics("volume", mesh, "-o", "out.vtp", "--light", "2,3,4")
                self.assertTrue(statistics["closed"])
                statistics = self.statistics("render", mesh, "-o", "out.png", "--ground", "--size",
                                             "160x120")
                self.assertEqual(statistics["meshes"][0]["nonFiniteTriangles"], touched)
                self.assertGreater(statistics["lights"][0]["shadowedPixels"], 500)

    def test_contours(self):
        touched = Meshes.write_broken_sphere(self.path("broken.vtp"), float("nan"), 17)
        Meshes.write_broken_sphere(self.path("nothing.vtp"), float("nan"))
        Meshes.write_broken_sphere(self.path("huge.vtp"), 1e300, 17)
        Meshes.write_ground(self.path("ground.obj"), 5, -2)
        common = ("--receiver", "ground.obj", "-o", "out.svg", "--light", "1,3,2", "--outlines")
        statistics = self.statistics("contour", "--caster", "broken.vtp", *common)
        self.assertEqual(statistics["casters"][0]["nonFiniteCells"], touched)
        drawing = Meshes.Drawing(self.path("out.svg"))
        for layer in ("contours", "creases", "outlines"):
            self.assertTrue(drawing.layers[layer], layer)
        points = [c for paths in drawing.layers.values() for path in paths for piece in path
                  for point in piece for c in point]
        self.assertTrue(all(map(math.isfinite, points)))
        os.remove(self.path("out.svg"))
        self.fail_in("nothing.vtp", "no triangle has finite points", "contour", "--caster",
                     "nothing.vtp", *common)
        self.fail_in("huge.vtp", "too large", "contour", "--caster", "huge.vtp", *common)

    def test_no_finite_triangle(self):
        mesh = self.path("mesh.vtp")
        touched = Meshes.write_broken_sphere(mesh, math.nan)
        self.assertEqual(touched, Meshes.SPHERE_TRIANGLES)
        self.fail_in(mesh, "finite", "render", mesh, "-o", "out.png")
        statistics = self.statistics("silhouette", mesh, "-o", "out.vtp", "--light", "2,3,4")
        self.assertEqual(statistics["loops"], 0)
        self.assertEqual(statistics["mesh"]["nonFiniteCells"], touched)

    def test_obj_coordinates_that_are_no_numbers(self):
        # Its reader would take them for 0.
        for value in ("nan", "inf", "x"):
            mesh = Meshes.write_tetrahedron(self.path("mesh.obj"), apex=(0, 0, value))
            self.fail_in(mesh, "line 4", "silhouette", mesh, "-o", "out.vtp", "--light", "2,3,4")


class Output(ToolTest):
    def setUp(self):
        super().setUp()
        Meshes.write_sphere(self.path("sphere.vtp"))

    def commands(self, image, data):
        light = ("--light", "1,2,3")
        return (("render", "sphere.vtp", "-o", image),
                ("render", "sphere.vtp", "-o", "out.png", "--mask", image),
                ("silhouette", "sphere.vtp", "-o", data, *light),
                ("contour", "--caster", "sphere.vtp", "--receiver", "sphere.vtp", "-o", data, *light),
                ("contour", "--caster", "sphere.vtp", "--receiver", "sphere.vtp", "-o",
                 data.replace(".vtp", ".svg"), "--outlines", *light),
                ("volume", "sphere.vtp", "-o", data, *light))

    @staticmethod
    def output(command, start):
        return next(word for word in command if word.startswith(start))

    def test_folder_as_output(self):
        os.mkdir(self.path("a.png"))
        os.mkdir(self.path("a.vtp"))
        os.mkdir(self.path("a.svg"))
        for command in self.commands("a.png", "a.vtp"):
            self.fail_in(self.output(command, "a."), "folder", *command)

    def test_missing_folder(self):
        for command in self.commands("no/a.png", "no/a.vtp"):
            self.fail_in("no", "does not exist", *command)

    def test_unwritable(self):
        # Nobody may make files there, root neither.
        for command in self.commands("/proc/a.png", "/proc/a.vtp"):
            self.fail_in(self.output(command, "/proc/a."), "cannot be written", *command)

    def test_no_room(self):
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))

        # Shader caches would be cut short too, which is none of the tool's doing.
        environment = dict(os.environ, MESA_SHADER_CACHE_DISABLE="true")
        for command in self.commands("a.png", "a.vtp"):
            with self.subTest(command):
                self.fail_with(1, *command, preexec_fn=limit, env=environment)

    def test_failure_leaves_what_was_there(self):
        with open(self.path("out.vtp"), "w") as file:
            file.write("precious")
        self.fail_with(1, "silhouette", "missing.vtp", "-o", "out.vtp", "--light", "1,2,3")
        with open(self.path("out.vtp")) as file:
            self.assertEqual(file.read(), "precious")

    def test_success_replaces_it(self):
        for name in ("out.vtp", "elsewhere.vtp"):
            with open(self.path(name), "w") as file:
                file.write("old")
        os.symlink("elsewhere.vtp", self.path("link.vtp"))
        for name in ("out.vtp", "link.vtp"):
            self.succeed("silhouette", "sphere.vtp", "-o", name, "--light", "1,2,3")
            self.assertGreater(Meshes.read_polydata(self.path(name)).GetNumberOfLines(), 0)
        self.assertTrue(os.path.islink(self.path("link.vtp")))
        self.assertEqual(sorted(os.listdir(self.folder)),
                         ["elsewhere.vtp", "link.vtp", "out.vtp", "sphere.vtp"])

    def test_rights_are_those_of_any_new_file(self):
        self.succeed("silhouette", "sphere.vtp", "-o", "out.vtp", "--light", "1,2,3",
                     preexec_fn=lambda: os.umask(0o027))
        self.assertEqual(os.stat(self.path("out.vtp")).st_mode & 0o777, 0o640)


class Windows(ToolTest):
    def test_osmesa_twin_draws_the_same(self):
        twin = TOOL + "-osmesa"
        if not os.path.exists(twin):
            self.skipTest("built without OSMesa")
        Meshes.write_sphere(self.path("sphere.vtp"))
        common = ("render", "sphere.vtp", "--ground", "--size", "320x240")
        egl = self.statistics(*common, "-o", "egl.png", "--mask", "egl-mask.png")
        osmesa = self.statistics(
            *common, "-o", "osmesa.png", "--mask", "osmesa-mask.png", tool=twin)
        self.assertEqual((egl["window"], osmesa["window"]), ("egl", "osmesa"))
        first, second = (Meshes.Image(self.path(name + "-mask.png")) for name in ("egl", "osmesa"))
        self.assertGreater(first.data.count(0), 2000)
        differing = sum(a != b for a, b in zip(first.data, second.data))
        self.assertLess(differing, 20)

    def test_missing_window_says_why(self):
        Meshes.write_sphere(self.path("sphere.vtp"))
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        self.fail_in("--window native", "no window", "render", "sphere.vtp", "-o", "out.png",
                     "--window", "native", env=environment)
        self.fail_in("--window osmesa", "no window", "render", "sphere.vtp", "-o", "out.png",
                     "--window", "osmesa")


class Terminal(ToolTest):
    def test_progress_on_a_terminal_only(self):
        Meshes.write_sphere(self.path("sphere.vtp"))
        try:
            leader, follower = pty.openpty()
        except OSError as error:
            self.skipTest(f"no terminal to be had here: {error}")
        run = subprocess.run(
            [TOOL, "silhouette", "sphere.vtp", "-o", "out.vtp", "--light", "1,2,3"],
            cwd=self.folder, stdout=subprocess.PIPE, stderr=follower, timeout=60)
        os.close(follower)
        shown = os.read(leader, 65536).decode()
        os.close(leader)
        self.assertEqual(run.returncode, 0)
        self.assertIn("reading sphere.vtp", shown)
        self.assertTrue(shown.endswith("\r\x1b[K"), "the line is not cleared")


if __name__ == "__main__":
    unittest.main()
