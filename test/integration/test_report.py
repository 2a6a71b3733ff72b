#!/usr/bin/python3
"""scripts/report on a run of seconds: figures, size, nothing fetched, the same bytes twice, hostile text, gaps, wall clock."""
import html.parser
import json
import os
import re
import shutil
import signal
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

from flights import ROOT, FlightCase, processes_with, program, shipped

REPORT, PICTURE = os.path.join(ROOT, "scripts", "report"), os.path.join(ROOT, "scripts", "picture")
LARGEST = 2_000_000    # bytes of report.html
HOSTILE = "<script>alert('$\\frac')</script><img src=x onerror=alert(1)>"
GRAPH = {"nodes": ["/gazebo", "/controller" + HOSTILE],
         "topics": {"/odometry" + HOSTILE: {"type": "nav_msgs/Odometry", "publishers": ["/gazebo"],
                                            "subscribers": ["/controller" + HOSTILE]},
                    "/tf" + HOSTILE: {"type": "tf2_msgs/TFMessage", "publishers": ["/gazebo"], "subscribers": []}},
         "services": {"/gazebo/step": ["/gazebo"]}}


class Page(html.parser.HTMLParser):
    """What a browser would find: elements, attributes, ids, text outside of <style>."""

    def __init__(self, text):
        super().__init__()
        self.elements, self.attributes, self.ids, self.text, self.styles, self.open = [], [], [], "", "", []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.elements.append(tag)
        self.open.append(tag)
        self.attributes += [(tag, name, value or "") for name, value in attributes]
        self.ids += [value for name, value in attributes if name == "id"]

    def handle_endtag(self, tag):
        if tag in self.open:
            del self.open[len(self.open) - 1 - self.open[::-1].index(tag):]

    def handle_data(self, data):
        if "style" in self.open:
            self.styles += data
        else:
            self.text += data


class Report(FlightCase):
    shared = None   # a flown run with its report, for all tests

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.shared = tempfile.mkdtemp(prefix="report test ")
        cls.addClassCleanup(shutil.rmtree, cls.shared, ignore_errors=True)

    def flown(self):
        """A copy of the run, its report made once."""
        run = os.path.join(self.shared, "run")
        if not os.path.exists(run):
            config = self.write("smoke.yaml", shipped("smoke.yaml", ("urdf: hummingbird.urdf", "urdf: '%s'" % os.path.join(
                os.environ.get("QUAD_BUILD", os.path.join(ROOT, "build")), "urdf", "hummingbird.urdf"))))
            answer = self.in_process(config, run)
            self.assertIn(answer.code, (0, 3), answer)
            answer = self.finish(self.start([program("quad_experiment", "quad_experiment"), "percentiles", "--results", run,
                                             "--seeds", "10"]))
            self.assertEqual(answer.code, 0, answer)
            self.assertEqual(self.report(run).stdout, "report: %s\n" % os.path.join(run, "report.html"))
        shutil.copytree(run, self.path("run"))
        return self.path("run")

    def report(self, run, *arguments, code=0):
        answer = self.finish(self.start([REPORT, run, *arguments]))
        self.assertEqual(answer.code, code, answer)
        return answer

    def page(self, run):
        with open(os.path.join(run, "report.html"), encoding="utf-8") as file:
            return Page(file.read())

    @staticmethod
    def contents(run):
        """{name: bytes} of what a report makes."""
        found = {"report.html": None}
        for folder in ("figures", "report"):
            found.update({os.path.join(folder, name): None for name in os.listdir(os.path.join(run, folder))})
        for name in found:
            with open(os.path.join(run, name), "rb") as file:
                found[name] = file.read()
        return found

    def assert_self_contained(self, page):
        self.assertFalse({"script", "link", "img", "iframe", "object", "embed", "base", "form", "video", "audio"} & set(page.elements))
        for tag, name, value in page.attributes:
            self.assertFalse(name.startswith("on"), (tag, name, value))
            self.assertNotIn(name, ("src", "srcset", "data", "action", "xmlns"), (tag, value))
            if name == "href":
                self.assertTrue(value.startswith("#"), (tag, value))
            for address in re.findall(r"url\(([^)]*)\)", value):
                self.assertTrue(address.startswith("#"), (tag, value))
        self.assertNotRegex(page.styles, r"@import|url\(|https?:")
        self.assertEqual(len(page.ids), len(set(page.ids)), "an id stands twice")
        referred = {value[1:] for _, name, value in page.attributes if name == "href"}
        self.assertLessEqual(referred, set(page.ids))

    def test_a_complete_report(self):
        run = self.flown()
        page = self.page(run)
        self.assertLess(os.path.getsize(os.path.join(run, "report.html")), LARGEST)
        self.assert_self_contained(page)
        figures = sorted(os.listdir(os.path.join(run, "figures")))
        self.assertGreaterEqual(len(figures), 17, figures)
        self.assertEqual(page.elements.count("svg"), len(figures))
        for name in figures:
            root = ElementTree.parse(os.path.join(run, "figures", name)).getroot()
            self.assertTrue(root.tag.endswith("svg"), name)
            self.assertGreater(len(list(root.iter())), 30, name)
        wanted = ["1.6", "1.7", "2.2", "2.3", *("2.%d" % i for i in range(5, 12)), *("3.%d" % i for i in range(1, 6))]
        self.assertEqual([n for n in wanted if "[thesis Fig. %s]" % n not in page.text], [])
        self.assertIn("thesis Fig. 1.4): not drawn. Reason: this run flew in one process", page.text)   # no nodes, no graph
        with open(os.path.join(run, "summary.json")) as file:
            summary = json.load(file)
        self.assertIn("The promise was %s." % ("kept" if summary["ok"] else "broken"), page.text)
        for part in (summary["config_hash"], summary["log_sha256"]["random"], "harmonics: [1, 2, 3]"):
            self.assertIn(part, page.text)
        self.assertNotIn("Wall-clock run", page.text)

    def test_the_table_is_the_one_the_run_printed(self):
        run = self.flown()
        with open(os.path.join(run, "table.json")) as file:
            rows = json.load(file)
        with open(os.path.join(run, "table.txt")) as file:
            printed = file.read()
        self.assertGreater(len(rows), 20)
        for row in rows:
            ours = "-" if row["ours"] is None else "%.6g" % row["ours"]
            self.assertRegex(printed, r"(?m)^%s +%s +%s  %s$" % tuple(map(re.escape, (row["label"], row["thesis"], ours,
                                                                                       row["verdict"]))))
            self.assertIn(row["kind"], ("certain", "statistical", "contradictory"))

    def test_the_same_bytes_again(self):
        run = self.flown()
        before = self.contents(run)
        shutil.rmtree(os.path.join(run, "figures"))
        os.remove(os.path.join(run, "report.html"))
        self.report(run)
        after = self.contents(run)
        self.assertEqual(sorted(before), sorted(after))
        self.assertEqual([name for name in before if before[name] != after[name]], [])

    def test_hostile_text_and_gaps(self):
        run = self.flown()
        self.edit(run, "table.json", lambda table: table[0].update(label=HOSTILE, note=HOSTILE))
        self.edit(run, "provenance.json", lambda p: p["versions"].update({"git": HOSTILE}))
        self.edit(run, "summary.json", lambda s: s.update(mode="lockstep"))
        with open(os.path.join(run, "graph.json"), "w") as file:
            json.dump(GRAPH, file)
        with open(os.path.join(run, "config.yaml"), "a") as file:
            file.write("# </pre>%s\n" % HOSTILE)
        os.remove(os.path.join(run, "percentiles.json"))
        with open(os.path.join(run, "random", "trajectory.csv"), "w") as file:
            file.write("k,t\n0,%s\n" % HOSTILE)
        answer = self.report(run, "--wallclock", self.wallclock_timing("another"))
        page = self.page(run)
        self.assert_self_contained(page)
        self.assertNotIn("Wall-clock run", page.text)
        self.assertIn("Delay that services add to each interval (wall clock, another run)", page.text)
        self.assertGreaterEqual(page.text.count("<script>"), 5)      # shown, not run
        self.assertIn("Topics without a listener: /tf<script>", page.text)
        for name, reason in (("among_seeds", "percentiles.json is not there"), ("fig_3_5_random_velocity", "cannot be read")):
            self.assertRegex(answer.stderr, "%s: not drawn, .*%s" % (name, reason))
            self.assertFalse(os.path.exists(os.path.join(run, "figures", name + ".svg")))   # the old one is gone
        self.assertIn("not drawn. Reason: percentiles.json is not there", page.text)
        self.assertIn("fig_2_11_velocity.svg", os.listdir(os.path.join(run, "figures")))

    def test_a_wallclock_run(self):
        run = self.flown()
        self.edit(run, "summary.json", lambda s: s.update(mode="wallclock"))
        self.wallclock_timing("run")
        self.report(run, "--pdf")
        names = {kind: sorted(n[:-4] for n in os.listdir(os.path.join(run, "figures")) if n.endswith(kind)) for kind in (".svg", ".pdf")}
        self.assertEqual(names[".svg"], names[".pdf"])
        for name in names[".pdf"]:
            with open(os.path.join(run, "figures", name + ".pdf"), "rb") as file:
                self.assertEqual(file.read(5), b"%PDF-")
        page = self.page(run)
        self.assertIn("Wall-clock run: not deterministic.", page.text)
        self.assertIn("Delay that services add to each interval (wall clock)", page.text)

    def test_what_is_not_a_run(self):
        for arrange in (lambda: None, lambda: os.mkdir(self.path("run")), lambda: self.write("run/summary.json", "{"),
                        lambda: self.write("run/summary.json", "[]")):
            arrange()
            answer = self.report(self.path("run"), code=2)
            self.assertRegex(answer.stderr, "^scripts/report: .*run is not a finished run: ")
            self.assertEqual(answer.stderr.count("\n"), 1)

    def test_interrupted_while_programs_run(self):
        run = self.flown()
        shutil.rmtree(os.path.join(run, "report"))
        self.assert_interrupt_leaves_nothing(run, lambda mine: any("lib/quad_experiment/" in line for line in mine), signal.SIGINT)

    def test_interrupted_while_figures_are_drawn(self):
        run = self.flown()
        shutil.rmtree(os.path.join(run, "figures"))
        os.remove(os.path.join(run, "report.html"))
        for wanted, number in ((1, signal.SIGINT), (2, signal.SIGTERM)):   # nothing, or something, is already there
            def some_are_drawn():
                return len([n for _, _, names in os.walk(run) for n in names if n.endswith(".svg")]) >= wanted
            self.assert_interrupt_leaves_nothing(run, lambda mine: some_are_drawn(), number)

    def assert_interrupt_leaves_nothing(self, run, condition, number):
        """Neither processes nor files, when the interrupt comes with `condition(command lines of what runs)`."""
        before = self.files(run)
        process = self.start([REPORT, run])
        self.wait_until(lambda: condition(processes_with(self.folder).values()), process)
        process.send_signal(number)
        answer = self.finish(process)
        self.assertEqual((answer.code, answer.stdout), (128 + number, ""), answer)
        self.assertEqual(answer.stderr, "scripts/report: interrupted; %s is as it was\n" % run)
        self.assertEqual(self.files(run), before)
        self.assertEqual(os.listdir(self.path("tmp")), [])

    @staticmethod
    def files(run):
        return sorted(os.path.join(folder, name) for folder, folders, names in os.walk(run) for name in folders + names)

    def test_a_stdout_that_cannot_be_written(self):
        run = self.flown()
        with open("/dev/full", "w") as full:
            process = self.start([REPORT, run], stdout=full)
        answer = self.finish(process)
        self.assertEqual(answer.code, 5, answer)
        page = os.path.join(run, "report.html")
        self.assertEqual(answer.stderr.splitlines()[-1], "scripts/report: standard output cannot be written (No space left on "
                                                         "device); the report stands in %s" % page)
        self.assertTrue(os.path.exists(page))

    def test_pictures(self):
        run = self.flown()
        for name, head in (("x.svg", b"<?xml"), ("x.png", b"\x89PNG"), ("new/x.pdf", b"%PDF-")):
            answer = self.finish(self.start([PICTURE, run, "--out", self.path(name)]))
            self.assertEqual((answer.code, answer.stdout, answer.stderr), (0, "", ""))
            with open(self.path(name), "rb") as file:
                self.assertEqual(file.read(len(head)), head)
        self.write("file", "")
        self.write("summary.json", "{}")
        before = self.files(self.folder)
        for results, out, code, words in ((run, self.path("x.foo"), 2, "must end in .svg"), (run, "/dev/full", 2, "must end in .svg"),
                                          (run, self.folder + "/run", 2, "must end in"), (run, "/proc/x.svg", 5, "cannot be written"),
                                          (run, self.path("file", "x.svg"), 5, "cannot be written"),
                                          (self.folder, self.path("y.svg"), 2, "is not a finished run"),
                                          (self.path("none"), self.path("y.svg"), 2, "is not a finished run")):
            answer = self.finish(self.start([PICTURE, results, "--out", out]))
            self.assertEqual((answer.code, answer.stdout, answer.stderr.count("\n")), (code, "", 1), answer)
            self.assertRegex(answer.stderr, "^scripts/picture: .*" + words)
        self.assertEqual(self.files(self.folder), before)

    def wallclock_timing(self, name):
        """A results directory with the timing of a flight on the wall clock."""
        os.makedirs(self.path(name, "targeted"), exist_ok=True)
        self.write(os.path.join(name, "targeted", "timing.csv"), "k,t,dT,dT_ctrl,service_delay,estimated_delay\n" + "".join(
            "%d,%g,%g,0.095,%g,0.005\n" % (k, 0.1 * k, 0.1 + 1e-4 * (k % 7), 0.005 + 1e-4 * (k % 7)) for k in range(-10, 40)))
        return self.path(name)

    def edit(self, run, name, change):
        with open(os.path.join(run, name), encoding="utf-8") as file:
            content = json.load(file)
        change(content)
        with open(os.path.join(run, name), "w", encoding="utf-8") as file:
            json.dump(content, file)


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    unittest.main()
