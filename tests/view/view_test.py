# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""The pages of `tandem view` in Chromium: python3 view_test.py TANDEM SOURCE [TEST...]"""

import os
import subprocess
import sys
import tempfile
import unittest

from browser import Browser, find_chromium

TANDEM, SOURCE = (os.path.abspath(path) for path in sys.argv[1:3])

# How many pixels of the scene are not empty, and a number that changes when any of them does.
PIXELS = """(() => {
  tandem.scene.draw();
  const from = tandem.scene.renderer.domElement, flat = document.createElement('canvas');
  [flat.width, flat.height] = [from.width, from.height];
  const context = flat.getContext('2d');
  context.drawImage(from, 0, 0);
  const data = context.getImageData(0, 0, flat.width, flat.height).data;
  let drawn = 0, sum = 0;
  const colours = new Set();
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] > 200) { ++drawn; colours.add(data[i] << 16 | data[i + 1] << 8 | data[i + 2]); }
    sum = (sum * 31 + data[i] + data[i + 1] * 3 + data[i + 2] * 7) % 1000000007;
  }
  return { drawn: drawn / (data.length / 4), colours: colours.size, sum };
})()"""


class ViewTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="tandem_view_test_")
        # Without its hardware WebGL takes seconds for each of its programs.
        cls.browser = Browser(find_chromium(), deadline=240.0)

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.folder.cleanup()

    def setUp(self):
        self.browser.size(1280, 900)
        self.browser.prefer(color_scheme="light")
        self.browser.errors.clear()
        self.browser.requests.clear()

    def tearDown(self):
        self.assertEqual(self.browser.errors, [])
        self.assertEqual([url for url in self.browser.requests if not url.startswith(("file:", "data:"))], [])

    def tandem(self, *arguments):
        subprocess.run([TANDEM, *arguments], cwd=self.folder.name, check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)

    def run_of(self, scenario, name, *settings):
        if not os.path.exists(os.path.join(self.folder.name, name)):
            sets = [word for setting in settings for word in ("--set", setting)]
            self.tandem("run", os.path.join(SOURCE, "scenarios", scenario), "--output", name, *sets)

    def open(self, name, *options):
        self.tandem("view", name, "--output", name + ".html", *options)
        self.browser.open(os.path.join(self.folder.name, name + ".html"))
        self.browser.frame()
        self.assertEqual(self.browser.errors, [])

    def open_four_bar(self):
        """The same page again where it is there already, as it was at first."""
        if self.value("window.tandem?.results[0].label ?? ''") == "four_bar" and self.value(
                "tandem.results[0].tables[0].times.length") == 1601:
            return self.value("""(() => { const { clock, scene } = tandem;
              clock.play(false); clock.set(0); clock.setSpeed(Clock.firstSpeed(2)); scene.look('begin');
              document.activeElement.blur(); scrollTo(0, 0);
              if (clock.repeat) document.getElementById('repeat').click(); })()""")
        self.run_of("mechanisms/four_bar/four_bar.toml", "four_bar", "run.stop=2")
        self.open("four_bar")

    def value(self, expression):
        return self.browser.value(expression)

    def test_draws_the_mechanism(self):
        self.open_four_bar()
        pixels = self.value(PIXELS)
        # Bars of 2.8 % of its size cover more than a thousandth of the picture and less than half.
        self.assertGreater(pixels["drawn"], 1e-3)
        self.assertLess(pixels["drawn"], 0.5)
        self.assertGreater(pixels["colours"], 50)
        self.assertGreater(self.value("tandem.plots.all.length"), 0)

    def test_looks_differ_with_time_and_not_without(self):
        self.open_four_bar()
        start = self.value(PIXELS)["sum"]
        self.assertEqual(self.value(PIXELS)["sum"], start)
        self.value("tandem.clock.set(0.7)")
        self.assertNotEqual(self.value(PIXELS)["sum"], start)

    def test_points_stand_where_the_results_say(self):
        self.open_four_bar()
        off = self.value("""(() => {
          const { clock, scene, results: [result] } = tandem;
          const times = result.tables[0].times;
          let worst = 0;
          for (const row of [0, 100, 1234, times.length - 1]) {
            clock.set(times[row]);
            scene.place(clock.time);
            for (const point of scene.mechanisms[0].points.filter((p) => p.columns.length))
              ['x', 'y'].forEach((axis, k) => {
                const column = result.column(`four_bar.${point.name}.${axis}`);
                worst = Math.max(worst, Math.abs(column.values[row] - point.value.getComponent(k)));
              });
          }
          return worst;
        })()""")
        self.assertEqual(off, 0)

    def test_plays_and_pauses(self):
        self.open_four_bar()
        self.value("document.getElementById('play').click()")
        self.assertTrue(self.value("tandem.clock.playing"))
        self.assertEqual(self.value("document.getElementById('play').getAttribute('aria-label')"), "Pause")
        for _ in range(200):
            self.browser.frame()
            if self.value("tandem.clock.time") > 0.05:
                break
        self.assertGreater(self.value("tandem.clock.time"), 0.05)
        self.value("document.getElementById('play').click()")
        stopped = self.value("tandem.clock.time")
        self.browser.frame()
        self.assertEqual(self.value("tandem.clock.time"), stopped)
        self.assertIn("Paused at", self.value("document.getElementById('said').textContent"))

    def test_stops_at_the_end_or_repeats(self):
        self.open_four_bar()
        tick = "(clock.before = 1000, clock.tick(1100))"
        self.value(f"(() => {{ const {{ clock }} = tandem; clock.set(1.99); clock.playing = true; {tick}; }})()")
        self.assertEqual(self.value("[tandem.clock.time, tandem.clock.playing]"), [2, False])
        self.value("document.getElementById('repeat').click()")
        self.value(f"(() => {{ const {{ clock }} = tandem; clock.playing = true; {tick}; clock.playing = false; }})()")
        self.assertEqual(self.value("tandem.clock.time"), 0)

    def test_slider_moves_time_and_cursor(self):
        self.open_four_bar()
        self.value("""(() => { const slider = document.getElementById('slider');
          slider.value = 1.5; slider.dispatchEvent(new Event('input')); })()""")
        self.assertEqual(self.value("tandem.clock.time"), 1.5)
        self.assertEqual(self.value("document.getElementById('slider').getAttribute('aria-valuetext')"), "1.500 s")
        at = self.value("""(() => { const [{ graph, cursor }] = tandem.plots.all;
          return new DOMMatrix(getComputedStyle(cursor).transform).m41 - graph.toDomXCoord(1.5); })()""")
        self.assertAlmostEqual(at, 0, delta=0.01)  # of a pixel

    def test_keys(self):
        self.open_four_bar()
        key = self.browser.key
        key("ArrowRight")
        self.assertAlmostEqual(self.value("tandem.clock.time"), 0.01)
        key("ArrowLeft")
        self.assertEqual(self.value("tandem.clock.time"), 0)
        key(".")
        self.assertEqual(self.value("tandem.clock.time"), self.value("tandem.results[0].tables[0].times[1]"))
        key("End")
        self.assertEqual(self.value("tandem.clock.time"), 2)
        key("Home")
        speed = self.value("tandem.clock.speed")
        key("+")
        self.assertGreater(self.value("tandem.clock.speed"), speed)
        key("-")
        self.assertEqual(self.value("tandem.clock.speed"), speed)
        key(" ")
        self.assertTrue(self.value("tandem.clock.playing"))
        key(" ")
        self.assertFalse(self.value("tandem.clock.playing"))

    def test_orbit_and_zoom(self):
        self.open_four_bar()
        camera = "tandem.scene.camera.position.toArray()"
        distance = "tandem.scene.camera.position.distanceTo(tandem.scene.controls.target)"
        x, y, w, h = self.value("(() => { const r = document.getElementById('canvas').getBoundingClientRect(); "
                                "return [r.x, r.y, r.width, r.height]; })()")
        middle = (x + w / 2, y + h / 2)
        before, far = self.value(camera), self.value(distance)
        self.browser.drag(middle, (middle[0] + 150, middle[1] + 40))
        self.browser.frame()
        self.assertNotEqual(self.value(camera), before)
        self.assertAlmostEqual(self.value(distance), far, delta=1e-6 * far)
        self.browser.mouse("mouseWheel", *middle, deltaX=0, deltaY=-200)
        self.browser.frame()
        self.assertLess(self.value(distance), 0.99 * far)
        before, near = self.value(camera), self.value(distance)
        self.browser.key("ArrowLeft", shift=True)
        self.assertNotEqual(self.value(camera), before)
        self.browser.key("o")
        self.assertGreater(self.value(distance), near)
        self.value("document.getElementById('front').click()")
        self.assertAlmostEqual(self.value(distance), far, delta=1e-6 * far)

    def test_a_click_in_a_plot_sets_the_time(self):
        self.open_four_bar()
        self.value("tandem.plots.all[0].body.scrollIntoView({ block: 'center', behavior: 'instant' })")
        self.browser.frame()
        x, y = self.value("""(() => { const { graph, body } = tandem.plots.all[0];
          const r = body.getBoundingClientRect(), area = graph.getArea();
          return [r.x + graph.toDomXCoord(1.25), r.y + area.y + area.h / 2]; })()""")
        self.browser.drag((x, y), (x, y))
        self.assertAlmostEqual(self.value("tandem.clock.time"), 1.25, delta=0.01)  # a pixel is 4 ms
        self.browser.drag((x, y), (x + 100, y))
        self.assertAlmostEqual(self.value("tandem.clock.time"), 1.25, delta=0.01)
        self.assertAlmostEqual(self.value("tandem.plots.window[0]"), 1.25, delta=0.01)
        windows = self.value("tandem.plots.all.map((plot) => plot.graph.xAxisRange()[0])")
        self.assertEqual(len(set(windows)), 1, "all plots show the same part of the time")
        self.value("document.getElementById('unzoom').click()")
        self.assertEqual(self.value("tandem.plots.all[0].graph.xAxisRange()"), [0, 2])

    def test_plots_are_chosen_added_and_removed(self):
        self.open_four_bar()
        count = self.value("tandem.plots.all.length")
        self.value("document.getElementById('add').click()")
        self.assertEqual(self.value("tandem.plots.all.length"), count + 1)
        self.value("""(() => { const { choice } = tandem.plots.all.at(-1); choice.selectedIndex = choice.options.length - 1;
          choice.dispatchEvent(new Event('change')); })()""")
        self.assertIn("over time, from", self.value("tandem.plots.all.at(-1).body.getAttribute('aria-label')"))
        self.value("document.querySelector('[aria-label=\"Remove this plot\"]').click()")
        self.assertEqual(self.value("tandem.plots.all.length"), count)
        self.browser.frame()  # and what observes its size is silent
        self.assertEqual(self.browser.errors, [])

    def test_every_control_has_a_name(self):
        self.open_four_bar()
        self.browser.call("Accessibility.enable")
        nodes = self.browser.call("Accessibility.getFullAXTree")["nodes"]
        controls = [n for n in nodes if not n.get("ignored") and n.get("role", {}).get("value") in (
            "button", "slider", "combobox", "checkbox", "image", "img", "toolbar", "spinbutton", "link")]
        self.assertGreater(len(controls), 15)
        unnamed = [n["role"]["value"] for n in controls if not n.get("name", {}).get("value")]
        self.assertEqual(unnamed, [])
        self.browser.call("Accessibility.disable")

    def test_keys_do_not_take_what_belongs_to_a_list(self):
        self.open_four_bar()
        self.value("document.getElementById('speed').focus()")
        self.browser.key("ArrowRight")
        self.assertEqual(self.value("tandem.clock.time"), 0)
        self.value("document.getElementById('play').focus()")
        self.browser.key(" ")
        self.assertTrue(self.value("tandem.clock.playing"), "the space bar presses the button once")

    def test_space_and_springs_and_bodies_of_one_point(self):
        for scenario, name in (("bricard", "bricard"), ("andrews", "andrews"), ("rotor", "rotor"),
                               ("spring_pendulum", "spring"), ("slider_crank", "slider"),
                               ("asymmetric_rotor", "asymmetric")):
            with self.subTest(name):
                self.run_of(f"mechanisms/{scenario}/{scenario}.toml", name, "run.stop=0.02")
                self.open(name)
                first = self.value(PIXELS)
                self.assertGreater(first["drawn"], 1e-3)
                self.value("tandem.clock.set(0.02)")
                self.assertNotEqual(self.value(PIXELS)["sum"], first["sum"])

    def test_two_results_are_laid_over_each_other(self):
        scene = "split_pendulum/split_pendulum.toml"
        self.run_of(scene, "split", "record.animate=true", "span.stop=0.5")
        self.run_of(scene, "held", "record.animate=true", "span.stop=0.5", "connections.reconstruction=lagrange0")
        self.open("split", "--with", "held")
        self.assertEqual(self.value("[...document.querySelectorAll('#legend li')].map((li) => li.textContent)"),
                         ["split", "held"])
        self.assertEqual(self.value("tandem.scene.drawings.length"), 4)
        self.value("document.getElementById('difference').click()")
        self.assertEqual(self.value("tandem.plots.all[0].graph.getLabels()"), ["t", "difference"])
        self.value("tandem.clock.set(0.25)")
        parts = self.value("""(() => { const [plot] = tandem.plots.all;
          return [...plot.columns.map((c) => c.at(0.25)), plot.values.textContent]; })()""")
        self.assertAlmostEqual(float(parts[2].split()[0]), parts[0] - parts[1],
                               delta=1e-3 * abs(parts[0] - parts[1]))

    def test_the_kart_rolls_on_its_wheels(self):
        scene = "kart/step_steer.toml"
        sets = ("record.animate=true", "span.stop=0.5", "subsystems.kart.parameters.step=5e-3")
        self.run_of(scene, "scalar_spins", *sets)
        self.run_of(scene, "whole_wheels", *sets, "subsystems.kart.source=mechanism:spatial.toml")
        self.open("scalar_spins", "--with", "whole_wheels")
        counts = "tandem.scene.mechanisms.map((m) => [m.wheels.length, m.springs.length, m.rods.length > 15])"
        self.assertEqual(self.value(counts), [[4, 4, True], [4, 4, True]])
        self.assertEqual(self.value("tandem.plots.all.map((plot) => plot.choice.value)"),
                         ["kart.roll", "kart.yaw", "driver.steering", "kart.load_FR", "defect(kart.torque)"])
        self.assertGreater(self.value(PIXELS)["drawn"], 1e-2)
        start = self.value(PIXELS)["sum"]
        self.value("tandem.clock.set(0.5)")
        self.assertNotEqual(self.value(PIXELS)["sum"], start)
        # Front left: a spoke in one, an angle in the other, turn by the same.
        turned = self.value("""(() => { const at = (result, name) => result.column(`kart.${name}`).at(0.5);
          const [a, b] = tandem.results;
          return [at(a, 'turn_FL'), Math.atan2(-at(b, 'm_FL.z'), at(b, 'm_FL.x'))]; })()""")
        self.assertAlmostEqual(turned[0] - turned[1], 0.0, delta=0.01)
        self.assertGreater(turned[0], 1.0)

    def test_without_a_mechanism_there_are_plots(self):
        self.run_of("two_mass/two_mass.toml", "two_mass", "span.stop=5")
        self.open("two_mass")
        self.assertTrue(self.value("document.getElementById('stage').hidden"))
        self.assertIn("plots only", self.value("document.getElementById('notes').textContent"))
        self.assertGreater(self.value("tandem.plots.all.length"), 0)
        self.browser.key("ArrowRight")
        self.assertGreater(self.value("tandem.clock.time"), 0)

    def test_a_held_output_is_drawn_in_steps(self):
        def write(name, text):
            with open(os.path.join(self.folder.name, name), "w", encoding="utf-8") as file:
                file.write(text)

        write("mass.toml", """name = "mass"
inputs = { u = { unit = "N" } }
blocks.v = { kind = "integrator", input = "u", initial = 0 }
blocks.y = { kind = "integrator", input = "v", initial = 0 }
outputs = { y = { unit = "m" } }
""")
        write("sampled.toml", f"""[subsystems.mass]
source = "diagram:mass.toml"
parameters = {{ step = 0.01 }}
[subsystems.control]
command = ["env", "PYTHONPATH={SOURCE}/transports/python", "python3", "{SOURCE}/transports/examples/pi.py"]
parameters = {{ kp = 1, ki = 0.1, r = 1, T = 0.25, offset = 0, latency = 0 }}
[[connections]]
from = "mass.y"
to = "control.y"
reconstruction = "lagrange2"
[[connections]]
from = "control.u"
to = "mass.u"
[span]
stop = 2
""")
        self.tandem("run", "sampled.toml", "--output", "sampled")
        self.open("sampled")
        self.value("void tandem.plots.add('control.u')")
        steps = self.value("""tandem.plots.all.map(({ graph, columns: [{ name }] }) =>
            [name, graph.getOption('stepPlot', `${name} (1)`)])""")
        self.assertIn(["control.u", True], steps)
        self.assertIn(["mass.y", False], steps)
        held = self.value("""(() => { const u = tandem.results[0].column('control.u');
          return [u.at(0.26), u.at(0.3), u.at(0.499), u.at(0.51)]; })()""")
        self.assertEqual(held[0], held[1])
        self.assertEqual(held[1], held[2])
        self.assertNotEqual(held[2], held[3])

    def test_dark_and_light(self):
        self.open_four_bar()
        colour = "getComputedStyle(document.body).backgroundColor"
        light, pixels = self.value(colour), self.value(PIXELS)["sum"]
        self.browser.prefer(color_scheme="dark")
        self.browser.frame()
        self.assertNotEqual(self.value(colour), light)
        self.assertNotEqual(self.value(PIXELS)["sum"], pixels)

    def test_fits_a_phone(self):
        self.browser.size(360, 740)
        self.open_four_bar()
        self.browser.frame()
        self.browser.frame()
        self.assertLessEqual(self.value("document.documentElement.scrollWidth"), 360)
        self.assertGreater(self.value(PIXELS)["drawn"], 1e-3)

    def test_a_name_can_not_break_the_page(self):
        name = "</script><script>window.broken=1</script> & <b>"
        with open(os.path.join(self.folder.name, "odd.csv"), "w", encoding="utf-8") as file:
            file.write(f'time,"{name}"\n0,1\n1,\n2,4\n')
        self.open("odd.csv")
        self.assertIsNone(self.value("window.broken ?? null"))
        self.assertEqual(self.value("tandem.results[0].columns[0].name"), name)
        self.value("tandem.clock.set(0.5)")
        self.assertEqual(self.value("tandem.plots.all[0].values.textContent"), "no value")

    def test_shows_what_hardly_changes_and_what_does_not(self):
        with open(os.path.join(self.folder.name, "flat.csv"), "w", encoding="utf-8") as file:
            file.write("time,noise,constant,zero,large,none\n")
            for k in range(100):
                file.write(f"{k},{-29.43 + k % 3 * 4e-15!r},1e7,0,{1e300 * (k - 50)!r},\n")
        self.open("flat.csv")
        names = self.value("tandem.results[0].columns.map((column) => column.name)")
        for name in names:
            self.value(f"void tandem.plots.add('{name}')")
        self.assertEqual(self.value("tandem.plots.all.length"), 4 + len(names))

    def test_left_out_rows_are_told(self):
        self.run_of("mechanisms/four_bar/four_bar.toml", "four_bar", "run.stop=2")
        self.open("four_bar", "--every", "10")
        self.assertIn("161 of 1601", self.value("document.getElementById('notes').textContent"))
        self.assertEqual(self.value("tandem.results[0].tables[0].times.length"), 161)
        self.assertEqual(self.value("tandem.clock.stop"), 2)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
