#!/usr/bin/python3
"""quad_experiment export: what it writes, opened by the programs it is for; a bag replayed through the controller node."""
import os
import shutil
import socket
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import numpy as np

from flights import DEVEL, ROOT, FlightCase, Results, program, shipped

sys.path[:0] = [os.path.join(DEVEL, "lib", "python3", "dist-packages")]   # mav_msgs
sys.path.append(os.path.join(ROOT, ".deps", "python"))                    # pyarrow
ASK = os.path.join(os.path.dirname(os.path.realpath(__file__)), "replay_and_ask.py")
EXPORT = program("quad_experiment", "quad_experiment")


class Export(FlightCase):
    shared = None

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.shared = tempfile.mkdtemp(prefix="export test ")
        cls.addClassCleanup(shutil.rmtree, cls.shared, ignore_errors=True)

    def smoke(self):
        urdf = os.path.join(os.environ.get("QUAD_BUILD", os.path.join(ROOT, "build")), "urdf", "hummingbird.urdf")
        return self.write("smoke.yaml", shipped("smoke.yaml", ("urdf: hummingbird.urdf", "urdf: '%s'" % urdf)))

    def exported(self, *formats):
        """A flown run, and the folder with these formats of it."""
        run = os.path.join(self.shared, "run")
        if not os.path.exists(run):
            answer = self.in_process(self.smoke(), run)
            self.assertIn(answer.code, (0, 3), answer)
        answer = self.export(run, "--out", self.path("out"), *formats)
        self.assertEqual(answer.code, 0, answer)
        return Results(run), self.path("out")

    def export(self, *arguments, env=None):
        return self.finish(self.start([EXPORT, "export", *arguments], env=env))

    @staticmethod
    def column(run, flight, name):
        return np.array([float(row[name] or "nan") for row in run.rows(flight + "/trajectory.csv")])

    def test_bag(self):
        import rosbag
        run, out = self.exported("--bag")
        for flight in ("targeted", "random"):
            with rosbag.Bag(os.path.join(out, flight + ".bag")) as bag:
                odometry = [m for _, m, _ in bag.read_messages("/hummingbird/odometry_sensor1/odometry")]
                speeds = [m for _, m, _ in bag.read_messages("/hummingbird/motor_speed")]
                inputs = [m for _, m, _ in bag.read_messages("/hummingbird/control/u")]
                self.assertEqual(bag.get_message_count("/experiment/flight_plan"), 1)
            t, rows = self.column(run, flight, "t"), len(run.rows(flight + "/trajectory.csv"))
            self.assertEqual((len(odometry), len(speeds), len(inputs)), (rows, rows - 1, rows - 1))
            self.assertEqual([m.header.stamp.to_nsec() for m in odometry], [round(x * 1e9) for x in t])
            self.assertEqual([m.header.stamp.to_nsec() for m in speeds], [round(x * 1e9) for x in t[1:]])
            self.assertEqual([m.pose.pose.position.z for m in odometry], list(self.column(run, flight, "z")))
            self.assertEqual([m.wrench.force.z for m in inputs], list(self.column(run, flight, "u1_cmd")[:-1]))
            # The twist is in body axes; tilt is rounding (1e-14 rad), so turning it changes the last digits only.
            np.testing.assert_allclose([m.twist.twist.linear.z for m in odometry], self.column(run, flight, "zdot"), atol=1e-12)
            measured = np.array([m.angular_velocities for m in speeds])
            self.assertEqual(np.sign(measured[0]).tolist(), [-1, 1, -1, 1])   # clockwise rotors are negative
            for i in range(4):
                self.assertEqual(list(abs(measured[:, i])), list(self.column(run, flight, "w%d" % i)[:-1]))

    def test_a_bag_in_the_programs_that_show_bags(self):
        """rosbag's own; and rqt_bag, which Debian 12 lacks, by the calls through which it draws a timeline and scrolls along it."""
        import rosbag
        import rospy
        import yaml
        run, out = self.exported("--bag")
        bag = os.path.join(out, "targeted.bag")
        answer = self.finish(self.start(["/usr/bin/rosbag", "info", "--yaml", bag]))
        self.assertEqual(answer.code, 0, answer)
        info = yaml.safe_load(answer.stdout)
        rows = len(run.rows("targeted/trajectory.csv"))
        self.assertTrue(info["indexed"])
        self.assertEqual({t["topic"]: t["messages"] for t in info["topics"]}["/hummingbird/motor_speed"], rows - 1)
        answer = self.finish(self.start(["/usr/bin/rosbag", "check", bag]))   # every type as this workspace has it
        self.assertEqual(answer.code, 0, answer)
        with rosbag.Bag(bag) as opened:
            start, end = rospy.Time.from_sec(opened.get_start_time()), rospy.Time.from_sec(opened.get_end_time())
            for topic in opened.get_type_and_topic_info().topics:
                entries = list(opened._get_entries(opened._get_connections(topic), start, end))
                self.assertEqual(len(entries), opened.get_message_count(topic), topic)
                middle = entries[len(entries) // 2]
                seen = opened._read_message(middle.position)
                self.assertEqual((seen.topic, seen.timestamp), (topic, middle.time))

    def test_mat(self):
        from scipy.io import loadmat
        run, out = self.exported("--mat")
        for flight in ("targeted", "random"):
            d = loadmat(os.path.join(out, flight + ".mat"), chars_as_strings=True)
            verdict, y, u = run.summary[flight], d["y"], d["u"]
            self.assertEqual((y.shape, u.shape, float(d["Ts"])), ((41, 2), (41, 1), 0.1))
            self.assertEqual([[str(n[0][0]) for n in d[key]] for key in ("OutputName", "OutputUnit", "InputName", "InputUnit")],
                             [["z", "zdot"], ["m", "m/s"], ["T_eff_FB"], ["N"]])
            self.assertEqual(str(d["TimeUnit"][0]), "seconds")
            self.assertTrue(np.isnan(u[-1, 0]) and not np.isnan(u[:-1]).any())
            phi = np.hstack([y[:-1], u[:-1]])
            theta = np.linalg.lstsq(phi / np.abs(phi).max(axis=0), y[1:], rcond=None)[0].T / np.abs(phi).max(axis=0)
            # The run's own least squares on the same data; z is near 5000 m, so rounding alone costs some 1e-9 in the columns.
            np.testing.assert_allclose(theta, np.hstack([verdict["A"], verdict["B"]]), atol=1e-8)

    def test_parquet(self):
        import pandas
        import pyarrow.parquet
        run, out = self.exported("--parquet")
        path = os.path.join(out, "trajectories.parquet")
        table = pandas.read_parquet(path)
        self.assertEqual(sorted(table["flight"].unique()), ["random", "targeted"])
        for flight, part in table.groupby("flight", observed=True):
            rows = run.rows(flight + "/trajectory.csv")
            self.assertEqual(list(part.columns), ["flight", *rows[0]])
            self.assertEqual(list(part["phase"]), [row["phase"] for row in rows])
            for name in set(rows[0]) - {"phase"}:
                np.testing.assert_array_equal(part[name].to_numpy(dtype=float), self.column(run, flight, name), name)
        schema = pyarrow.parquet.read_schema(path)
        self.assertEqual(schema.field("zdot").metadata[b"unit"], b"m/s")
        self.assertEqual(schema.metadata[b"config.yaml"], run.bytes("config.yaml"))

    def test_a_batch_as_parquet(self):
        import pandas
        self.smoke()
        self.write("spec.yaml", "base: smoke.yaml\nruns: 2\nseed: 1\nvary:\n  design.gamma_w: {grid: [4.0, 1e-6]}\n")
        batch = self.path("batch")
        answer = self.finish(self.start([EXPORT, "batch", "--spec", self.path("spec.yaml"), "--out", batch, "--workers", "1"]))
        self.assertIn(answer.code, (0, 3), answer)
        self.assertEqual(self.export(batch, "--parquet").code, 0)
        table = pandas.read_parquet(os.path.join(batch, "export", "results.parquet"))
        plain = pandas.read_csv(os.path.join(batch, "results.csv"), float_precision="round_trip")
        self.assertEqual(list(table.columns), list(plain.columns))
        self.assertEqual(list(table["status"]), list(plain["status"]))
        for name in ("run", "design.gamma_e", "targeted.residual_energy"):
            np.testing.assert_array_equal(table[name].to_numpy(dtype=float), plain[name].to_numpy(dtype=float), name)
        refused = self.export(batch, "--bag")
        self.assertEqual(refused.code, 2, refused)
        self.assertIn("exports as --parquet only", refused.stderr)

    def test_plotjuggler(self):
        import pandas
        run, out = self.exported("--plotjuggler")
        folder = os.path.join(out, "plotjuggler")
        layout = ElementTree.parse(os.path.join(folder, "layout.xml")).getroot()
        tables = {file.get("prefix"): pandas.read_csv(os.path.join(folder, file.get("filename")), float_precision="round_trip")
                  for file in layout.iter("fileInfo")}
        self.assertEqual(sorted(tables), ["random", "targeted"])
        for flight, table in tables.items():
            self.assertTrue(all(kind.kind in "fi" for kind in table.dtypes), table.dtypes)
            self.assertEqual(list(table["z"]), list(self.column(run, flight, "z")[:-1]))
        curves = [curve.get("name") for curve in layout.iter("curve")]
        self.assertGreater(len(curves), 20)
        for curve in curves:
            flight, name = curve.split("/")
            self.assertIn(name, tables[flight].columns)

    def test_a_bag_replays_through_the_controller(self):
        run, out = self.exported("--bag")
        bag = os.path.join(out, "targeted.bag")
        with socket.socket() as holder:
            holder.bind(("127.0.0.1", 0))
            port = holder.getsockname()[1]
        env = dict(self.environment, ROS_MASTER_URI="http://127.0.0.1:%d" % port, ROS_IP="127.0.0.1", ROS_HOME=self.path("ros"),
                   ROS_LOG_DIR=self.path("ros"))
        answer = self.finish(self.start(["/usr/bin/python3", ASK, str(port), bag, os.path.join(run.path, "config.yaml")], env=env))
        self.assertEqual(answer.code, 0, answer)
        replayed = np.array([[float(x) for x in line.split()] for line in answer.stdout.splitlines()])
        recorded = np.column_stack([self.column(run, "targeted", name)[:-1] for name in ("t", "u1_cmd", "tau_phi", "tau_theta", "tau_psi")])
        self.assertEqual(len(replayed), len(recorded) + 1)   # the last state is answered, too
        np.testing.assert_allclose(replayed[:-1, 0], recorded[:, 0], atol=1e-9)
        # Rounding of the climb rate, turned into body axes and back, times gains of a few N s/m and a second of integration.
        np.testing.assert_allclose(replayed[:-1, 1:], recorded[:, 1:], atol=1e-9)

    def test_what_cannot_be_exported(self):
        run, _ = self.exported("--mat")
        answer = self.export(run.path)
        self.assertEqual((answer.code, answer.stderr.count("\n")), (2, 1), answer)
        self.assertIn("give --bag, --mat, --parquet or --plotjuggler", answer.stderr)
        answer = self.export(self.path("nowhere"), "--mat")
        self.assertEqual(answer.code, 2, answer)
        self.assertIn("nowhere is not a finished run", answer.stderr)
        os.mkdir(self.path("shadow"))
        self.write("shadow/scipy.py", "raise ImportError(name='scipy')\n")
        answer = self.export(run.path, "--mat", "--out", self.path("none"), env=dict(self.environment, PYTHONPATH=self.path("shadow")))
        self.assertEqual(answer.code, 5, answer)
        self.assertEqual(answer.stderr, "quad_experiment export: --mat needs scipy; run: apt-get install python3-scipy\n")
        alone = shutil.copy(EXPORT, self.path("quad_experiment"))   # as installed without its Python programs
        answer = self.finish(self.start([alone, "export", run.path, "--mat"]))
        self.assertEqual(answer.code, 5, answer)
        self.assertRegex(answer.stderr, "export_run is not there; run: make build")


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    unittest.main()
