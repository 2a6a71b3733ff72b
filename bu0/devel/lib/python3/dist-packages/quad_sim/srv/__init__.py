from ._CommandReport import *
from ._RestoreState import *
from ._SaveState import *
from ._Step import *
