"""The report of a finished run: figures and tables of a paper, in one HTML file. Used by scripts/report.

run.py reads a results directory, supplement.py makes what a run does not leave, *_figures.py draw (one group of figures
a file, listed in figures.py), page.py fills report.html.j2; whole.py runs all that and puts it in place at once.
"""
