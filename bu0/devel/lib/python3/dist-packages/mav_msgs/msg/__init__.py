from ._Actuators import *
from ._AttitudeThrust import *
from ._RateThrust import *
