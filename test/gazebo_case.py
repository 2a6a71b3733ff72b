"""What the tests of gazebo_services.test share: calls, and a vehicle that comes for one test."""
import os
import shutil
import tempfile
import time
import unittest

import rospy
from gazebo_msgs import srv as ask
from geometry_msgs.msg import Point, Pose, Quaternion
from quad_sim.srv import SaveState, Step
from std_srvs.srv import Empty

G, MASS = 9.8, 0.73103  # of the configuration and of the URDF
LEVEL = Quaternion(0, 0, 0, 1)


def call(name, kind, *request, **fields):
    rospy.wait_for_service(name, 20)
    return rospy.ServiceProxy(name, kind)(*request, **fields)


def step(steps):
    answer = call("/gazebo/step", Step, steps=steps)
    assert answer.success, answer.message
    return answer


def link(name, frame=""):
    return call("/gazebo/get_link_state", ask.GetLinkState, name, frame)


def eventually(condition, seconds=20):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.01)
    return condition()


def saved(vehicle):
    """The lines of one vehicle in the saved state of the world."""
    parts = call("/gazebo/save_state", SaveState).state.split("vehicle ")
    return next(p for p in parts if p.startswith(vehicle + "\n"))


def plugin(filename, **tags):
    text = "".join("<%s>%s</%s>" % (k, v, k) for k, v in tags.items())
    return ('<gazebo><plugin name="added" filename="%s"><robotNamespace>hummingbird</robotNamespace>%s</plugin></gazebo>'
            % (filename, text))


class GazeboCase(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()
        with open(rospy.get_param("/test_urdf"), encoding="utf-8") as file:
            cls.urdf = file.read()

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def setUp(self):
        call("/gazebo/pause_physics", Empty)
        call("/gazebo/reset_simulation", Empty)

    def spawn(self, name, z=3.0, x=4.0, added="", **fields):
        pose = Pose(Point(x, 0, z), LEVEL)
        request = dict(model_name=name, model_xml=self.urdf.replace("</robot>", added + "</robot>"), initial_pose=pose)
        request.update(fields)
        answer = call("/gazebo/spawn_urdf_model", ask.SpawnModel, **request)
        if answer.success:
            self.addCleanup(call, "/gazebo/delete_model", ask.DeleteModel, name)
        return answer

    def listen(self, topic, kind, callback):
        """Until the end of the test. rospy keeps one subscription a topic: one that outlives its test would lend the
        next test its type, and its connection to a publisher that is gone."""
        subscriber = rospy.Subscriber(topic, kind, callback, queue_size=1)
        self.addCleanup(subscriber.unregister)

    def wind_and_bag(self, **tags):
        settings = dict(bagFileName=os.path.join(self.folder, "flight.bag"), linkName="hummingbird/base_link",
                        frameId="hummingbird/base_link", rotorVelocitySlowdownSim="10", waitToRecordBag="true")
        settings.update(tags)
        return (plugin("librotors_gazebo_bag_plugin.so", **settings) +
                plugin("librotors_gazebo_wind_plugin.so", linkName="hummingbird/base_link", xyzOffset="0 0 0",
                       windForceMean="0.5", windDirection="1 0 0", frameId="world"))
