from ._WindSpeed import *
