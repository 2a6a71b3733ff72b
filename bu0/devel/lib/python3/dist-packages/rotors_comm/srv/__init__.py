from ._RecordRosbag import *
