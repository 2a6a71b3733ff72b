"""ROS 1 bag: <flight>.bag with the topics of the flight under their names and stamps, for rosbag, rqt and the controller node.

/<ns>/odometry_sensor1/odometry and /<ns>/control/u (what the controller answered) at t_k, /<ns>/motor_speed at t_{k+1}, and
/experiment/flight_plan: what the controller was told before the flight, as JSON, which `replay_bag` hands to a controller again.
Horizontal velocity and body rates are differences of what trajectory.csv has (central, of position and attitude); everything
else is as recorded.
"""
import json
import math
import os
import xml.etree.ElementTree as ElementTree

import numpy as np

from .flights import Missing, write_whole

EARLIEST = 1   # [ns]: a bag takes no message at time zero


def write(run, folder):
    try:
        import genpy
        import rosbag
        from geometry_msgs.msg import WrenchStamped
        from mav_msgs.msg import Actuators
        from nav_msgs.msg import Odometry
        from std_msgs.msg import String
    except ImportError as error:
        raise Missing("--bag needs the Python module %s; run: scripts/setup && make build" % error.name)

    def stamp(ns):
        return genpy.Time(*divmod(int(ns), 10 ** 9))

    signs = spins(run)

    def messages(flight):
        """(time [ns], topic, message) in order of time."""
        prefix = "/" + run.namespace.strip("/") + "/"
        times = flight.nanoseconds
        yield EARLIEST, "/experiment/flight_plan", String(json.dumps(plan(run, flight)))
        velocity, rates = differences(flight)
        for k, ns in enumerate(times):
            odometry = Odometry()
            fill_odometry(odometry, flight, k, velocity[k], rates[k])
            odometry.header.seq, odometry.header.stamp = k, stamp(ns)
            odometry.header.frame_id, odometry.child_frame_id = "world", run.namespace + "/base_link"
            yield ns, prefix + "odometry_sensor1/odometry", odometry
            if math.isnan(flight["u1_cmd"][k]):
                continue
            u = WrenchStamped()
            u.header.seq, u.header.stamp, u.header.frame_id = k, stamp(ns), odometry.child_frame_id
            u.wrench.force.z = flight["u1_cmd"][k]
            u.wrench.torque.x, u.wrench.torque.y, u.wrench.torque.z = (flight[n][k] for n in ("tau_phi", "tau_theta", "tau_psi"))
            yield ns, prefix + "control/u", u
            speeds = Actuators()
            speeds.header.seq, speeds.header.stamp = k, stamp(times[k + 1])
            speeds.angular_velocities = [sign * flight[rotor][k] for sign, rotor in zip(signs, flight.rotors)]
            yield times[k + 1], prefix + "motor_speed", speeds

    def fill(path, flight):
        with rosbag.Bag(path, "w") as bag:
            for ns, topic, message in messages(flight):
                bag.write(topic, message, stamp(max(ns, EARLIEST)))

    return [write_whole(os.path.join(folder, flight.name + ".bag"), lambda path, flight=flight: fill(path, flight))
            for flight in run.flights]


def plan(run, flight):
    """The request of set_flight_plan, by its field names; the stamp in nanoseconds."""
    gravity = float(run.config["simulation"]["gravity"])
    estimate = float(run.config["estimate"]["mass"])
    truth = run.summary.get("truth", {}).get("m", run.config["vehicle"]["mass"])
    if not isinstance(truth, (int, float)):
        raise Missing("--bag: summary.json does not say which mass was flown; fly again with this version")
    explored = flight.explore & ~np.isnan(flight["t_eff_cmd"])
    start = [ns for ns, explore in zip(flight.nanoseconds, flight.explore) if explore]
    return {"x": 0.0, "y": 0.0, "z": float(run.config["simulation"]["initial_altitude"]), "yaw": 0.0, "feed_forward_mass": estimate,
            "initial_altitude_effort": (truth - estimate) * gravity, "exploration_start_ns": start[0] if start else 0,
            "exploration_signal": [float(u) for u in flight["t_eff_cmd"][explored]]}


def spins(run):
    """+1 (counter-clockwise) or -1 for each rotor, from the vehicle's URDF: signs of the topic motor_speed."""
    urdf = run.config["vehicle"]["urdf"]
    try:
        plugins = [p for p in ElementTree.parse(urdf).iter("plugin") if p.find("turningDirection") is not None]
        found = {int(p.findtext("motorNumber")): 1 if p.findtext("turningDirection").strip() == "ccw" else -1 for p in plugins}
        return [found[i] for i in range(len(found))]
    except (OSError, ElementTree.ParseError, ValueError, TypeError, KeyError) as error:
        raise Missing("--bag needs the vehicle's URDF for the rotors' directions: %s: %s" % (urdf, error))


def rotation(phi, theta, psi):
    """R_WB of roll, pitch, yaw (about z, then y, then x)."""
    (c1, s1), (c2, s2), (c3, s3) = ((math.cos(a), math.sin(a)) for a in (phi, theta, psi))
    return np.array([[c3 * c2, c3 * s2 * s1 - s3 * c1, c3 * s2 * c1 + s3 * s1],
                     [s3 * c2, s3 * s2 * s1 + c3 * c1, s3 * s2 * c1 - c3 * s1],
                     [-s2, c2 * s1, c2 * c1]])


def quaternion(phi, theta, psi):
    """(x, y, z, w) of the same attitude."""
    (c1, s1), (c2, s2), (c3, s3) = ((math.cos(a / 2), math.sin(a / 2)) for a in (phi, theta, psi))
    return (s1 * c2 * c3 - c1 * s2 * s3, c1 * s2 * c3 + s1 * c2 * s3, c1 * c2 * s3 - s1 * s2 * c3, c1 * c2 * c3 + s1 * s2 * s3)


def differences(flight):
    """World velocity [m/s] with the recorded climb rate, and body rates [rad/s] from the attitude's differences: n x 3 each."""
    t = flight["t"]
    slope = {name: np.gradient(np.unwrap(flight[name]) if name in ("phi", "theta", "psi") else flight[name], t) if len(t) > 1
             else np.zeros(1) for name in ("x", "y", "phi", "theta", "psi")}
    velocity = np.column_stack([slope["x"], slope["y"], flight["zdot"]])
    phi, theta = flight["phi"], flight["theta"]
    rates = np.column_stack([slope["phi"] - slope["psi"] * np.sin(theta),
                             slope["theta"] * np.cos(phi) + slope["psi"] * np.sin(phi) * np.cos(theta),
                             slope["psi"] * np.cos(phi) * np.cos(theta) - slope["theta"] * np.sin(phi)])
    return velocity, rates


def fill_odometry(odometry, flight, k, velocity, rates):
    """Pose in world axes, twist in body axes, as nav_msgs has it."""
    attitude = [flight[name][k] for name in ("phi", "theta", "psi")]
    pose, twist = odometry.pose.pose, odometry.twist.twist
    pose.position.x, pose.position.y, pose.position.z = (flight[name][k] for name in ("x", "y", "z"))
    q = pose.orientation
    q.x, q.y, q.z, q.w = quaternion(*attitude)
    twist.linear.x, twist.linear.y, twist.linear.z = rotation(*attitude).T @ velocity
    twist.angular.x, twist.angular.y, twist.angular.z = rates
