"""What figures need and a run does not leave, made once by the run's own programs and kept beside it in <results>/report/.

An altitude step (Figs 2.2, 2.3), the published algorithm's iterations (Figs 2.5 to 2.7), the same flights without simulated
timing noise, and textbook signals of equal energy. All are deterministic; wall times are left out of what is kept. The timing of a
wall-clock run (Figs 1.6, 1.7) is copied.
"""
import json
import os
import shutil
import subprocess
import tempfile
from functools import partial
from multiprocessing.pool import ThreadPool

import yaml

from .run import Flight, Gap, read_columns, read_json

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
FOLDER = "report"
LIMIT = 300     # [s] for one program
STEP_SECONDS = 10.0
COMPARED_SEEDS = 5
# Stops when cost and step change less than this, relatively: the thesis stops at a threshold, too, without naming it.
COST_TOLERANCE, STEP_TOLERANCE = "1e-5", "1e-2"


def program(package, name):
    """The built program: of this workspace, or of the one whose setup.sh was sourced."""
    prefixes = [os.path.join(ROOT, "build", "devel")] + os.environ.get("CMAKE_PREFIX_PATH", "").split(":")
    for prefix in filter(None, prefixes):
        path = os.path.join(prefix, "lib", package, name)
        if os.access(path, os.X_OK):
            return path
    raise Gap("the program %s is not built; run: make build" % name)


def call(command, good=(0, 3)):
    env = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    try:
        done = subprocess.run(command, env=env, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              timeout=LIMIT)
    except subprocess.TimeoutExpired:
        raise Gap("%s did not end within %d s" % (os.path.basename(command[0]), LIMIT))
    if done.returncode not in good:
        lines = done.stderr.decode(errors="replace").strip().splitlines() or ["no word"]
        raise Gap("%s %s ended with exit code %d: %s" % (os.path.basename(command[0]), command[1], done.returncode, lines[0]))


def made(run, name):
    """The path of report/<name>, where it has been made: by an earlier report or, aside, by this one; else None."""
    for path in (os.path.join(run.aside, FOLDER, name), run.file(FOLDER, name)):
        if os.path.exists(path):
            return path
    return None


def kept(run, name, make):
    """The path of report/<name>; make(folder) returns its content where it is not there yet."""
    path = made(run, name)
    if not path:
        with tempfile.TemporaryDirectory(prefix="quad_report.") as folder:
            text = make(folder)
        path = os.path.join(run.aside, FOLDER, name)
        write(path, text)
    return path


def write(path, data):
    """Whole or not at all, for those who look while it is written."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    part = "%s.partial-%d" % (path, os.getpid())
    with open(part, "wb") as file:
        file.write(data if isinstance(data, bytes) else data.encode())
    os.replace(part, path)


def text_of(*names):
    with open(os.path.join(*names), encoding="utf-8") as file:
        return file.read()


def in_process_config(run, folder, noisy):
    """The run's configuration for a flight in one process; `noisy` keeps the simulated latency and jitter."""
    config = json.loads(json.dumps(run.config))
    config["timing"]["mode"] = "lockstep"
    if not noisy:
        config["timing"].update(latency=0.0, jitter_std=0.0)
    path = os.path.join(folder, "config.yaml")
    with open(path, "w", encoding="utf-8") as file:
        yaml.safe_dump(config, file, default_flow_style=None)
    return path


def altitude_step(run):
    """A step of 1 m under PI control, without timing noise."""
    def make(folder):
        call([program("quad_experiment", "quad_experiment"), "step", "--config", in_process_config(run, folder, noisy=False),
              "--duration", str(STEP_SECONDS), "--out", os.path.join(folder, "step")])
        return text_of(folder, "step", "trajectory.csv")
    return Flight(kept(run, "step.csv", make))


def iterations(run, plain):
    """The answer of `explore_opt design --method mm`; `plain` as the paper has it, else with lengthened steps."""
    def make(folder):
        model, design = run.estimate(), run.config["design"]
        problem, answer = os.path.join(folder, "problem.json"), os.path.join(folder, "answer.json")
        with open(problem, "w", encoding="utf-8") as file:
            json.dump({"A": model.A.tolist(), "B": [[b] for b in model.B], "T": design["num_samples"],
                       "harmonics": design["harmonics"], "phase": design["phase"], "gamma_w": design["gamma_w"],
                       "D_des": design["desired_closeness"]}, file)
        call([program("explore_opt", "explore_opt"), "design", problem, "--method", "mm", "--cost-tolerance", COST_TOLERANCE,
              "--step-tolerance", STEP_TOLERANCE, "--out", answer] + (["--plain"] if plain else []))
        found = read_json(answer)
        found.pop("seconds", None)
        return json.dumps(found) + "\n"
    return read_json(kept(run, "mm_plain.json" if plain else "mm.json", make))


def without_timing_noise(run):
    """The verdicts of the same experiment, latency and jitter zero."""
    def make(folder):
        call([program("quad_experiment", "quad_experiment"), "run", "--config", in_process_config(run, folder, noisy=False),
              "--out", os.path.join(folder, "exact")])
        summary = read_json(os.path.join(folder, "exact", "summary.json"))
        for part in (summary, summary.get("targeted") or {}, summary.get("random") or {}):
            part.pop("wall_seconds", None)
        return json.dumps(summary, indent=1) + "\n"
    return read_json(kept(run, "without_timing_noise.json", make))


def comparison(run):
    """Textbook signals of the same energy, flown with the same simulated middleware: comparison.json of `quad_experiment compare`."""
    def make(folder):
        call([program("quad_experiment", "quad_experiment"), "compare", "--config", in_process_config(run, folder, noisy=True),
              "--seeds", str(COMPARED_SEEDS), "--out", os.path.join(folder, "compare")])
        return text_of(folder, "compare", "comparison.json")
    return read_json(kept(run, "comparison.json", make))


def prepare(run):
    """Makes what is missing, all at once. What cannot be made is left to the figure that needs it, which says so."""
    def attempt(make):
        try:
            make(run)
        except Gap:
            pass
    with ThreadPool(os.cpu_count() or 1) as pool:
        pool.map(attempt, (comparison, partial(iterations, plain=True), partial(iterations, plain=False), altitude_step,
                           without_timing_noise), chunksize=1)


def keep_wallclock(run, results):
    """Copies the timing of the wall-clock run `results` beside this one, for Figs 1.6 and 1.7."""
    source = os.path.join(results, "targeted", "timing.csv")
    if not os.path.exists(source):
        raise FileNotFoundError("%s: no such file; --wallclock wants a run of config/wallclock.yaml" % source)
    os.makedirs(os.path.join(run.aside, FOLDER), exist_ok=True)
    shutil.copyfile(source, os.path.join(run.aside, FOLDER, "wallclock_timing.csv"))


def wallclock_timing(run):
    """(columns of timing.csv, whether they are this run's own)."""
    if run.wallclock:
        return read_columns(run.file("targeted", "timing.csv")), True
    path = made(run, "wallclock_timing.csv")
    if path:
        return read_columns(path), False
    raise Gap("a lock-step run has no service delay")
