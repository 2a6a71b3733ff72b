from ._LinkState import *
from ._LinkStates import *
from ._ModelState import *
from ._ModelStates import *
from ._ODEPhysics import *
from ._PerformanceMetrics import *
from ._SensorPerformanceMetric import *
