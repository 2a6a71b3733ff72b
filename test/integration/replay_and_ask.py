#!/usr/bin/python3
"""Replays a bag with launch/replay.launch and prints what the controller answered: t, thrust, torques, one line an odometry.

Usage: replay_and_ask.py PORT BAG CONFIG   For test_export.py. The controller itself is asked (flight_record), since topics may lose messages.
"""
import os
import signal
import subprocess
import sys
import time

import rosbag
import rosgraph
import rospy
from quad_control.srv import FlightRecord

LAUNCH = os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "launch", "replay.launch")
ATTEMPTS = 3        # a loaded machine may drop an odometry message from a queue of ten
LIMIT = 30.0        # [s] for one attempt


def replay(port, bag, config, wanted):
    """The record after one replay."""
    process = subprocess.Popen(["roslaunch", "-p", port, "--skip-log-check", "--sigint-timeout", "2", LAUNCH, "bag:=" + bag,
                                "config:=" + config, "rate:=2", "required:=false"], stdout=subprocess.DEVNULL, start_new_session=True)
    try:
        name = "/hummingbird/attitude_altitude_controller/flight_record"
        end = time.monotonic() + LIMIT
        while not rosgraph.is_master_online() and time.monotonic() < end and process.poll() is None:
            time.sleep(0.05)
        if process.poll() is not None:
            sys.exit("roslaunch ended with exit code %d" % process.returncode)
        rospy.init_node("replay_and_ask", disable_rostime=True)   # once is enough: a second call does nothing
        rospy.wait_for_service(name, LIMIT)
        ask = rospy.ServiceProxy(name, FlightRecord)
        last, changed = -1, time.monotonic()
        while time.monotonic() < end:
            record = ask()
            if len(record.time) >= wanted:
                return record
            if len(record.time) != last:
                last, changed = len(record.time), time.monotonic()
            elif last > 0 and time.monotonic() - changed > 5.0:
                return record   # nothing more comes
            time.sleep(0.1)
        return ask()
    finally:
        process.send_signal(signal.SIGINT)
        process.wait()


def main(port, bag, config):
    with rosbag.Bag(bag) as file:
        wanted = file.get_message_count("/hummingbird/odometry_sensor1/odometry")
    for _ in range(ATTEMPTS):
        record = replay(port, bag, config, wanted)
        if len(record.time) == wanted:
            break
    for row in zip(record.time, record.thrust, record.tau_phi, record.tau_theta, record.tau_psi):
        print(repr(row[0].to_sec()), *map(repr, row[1:]))


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
