from ._Advance import *
from ._Begin import *
from ._FlightRecord import *
from ._SetFlightPlan import *
from ._TimingReport import *
