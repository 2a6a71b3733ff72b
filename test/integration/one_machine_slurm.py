"""A Slurm of this machine alone, in a folder of its own, gone with the test."""
import os
import re
import socket
import subprocess
import time

CONF = """ClusterName=test
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/none
CredType=cred/none
SlurmUser=root
SlurmctldPort={controller}
SlurmdPort={node}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
SlurmdParameters=config_overrides
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class OneMachineSlurm:
    def __init__(self, folder):
        self.folder, self.daemons = folder, []   # without spaces: slurm.conf knows no quotes

    def __enter__(self):
        for name in ("", "state", "spool"):
            os.makedirs(os.path.join(self.folder, name), exist_ok=True)
        self.conf = os.path.join(self.folder, "slurm.conf")
        with open(self.conf, "w", encoding="utf-8") as file:
            file.write(CONF.format(host=socket.gethostname().split(".")[0], folder=self.folder, controller=free_port(),
                                   node=free_port()))
        self.environment = dict(os.environ, SLURM_CONF=self.conf, PATH=os.environ["PATH"] + ":/usr/sbin:/sbin")
        for daemon in ("slurmctld", "slurmd"):
            self.daemons.append(subprocess.Popen([daemon, "-D", "-f", self.conf], env=self.environment, stdin=subprocess.DEVNULL,
                                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
        self.until(lambda: "idle" in self.ask("sinfo", "--noheader", "-o", "%T"), 40, "the node is not idle")
        return self

    def __exit__(self, *_):
        self.ask("scancel", "--state=PENDING")
        self.ask("scancel", "--state=RUNNING")
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def ask(self, *command):
        return subprocess.run(command, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=30,
                              check=False).stdout

    def until(self, condition, seconds, complaint):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                raise AssertionError("%s after %g s\n%s" % (complaint, seconds, self.logs()))
            time.sleep(0.2)

    def submit(self, arguments, folder, environment):
        """sbatch in a folder; the job's number."""
        answer = subprocess.run(["sbatch", "--chdir", folder, *arguments], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                env=dict(environment, SLURM_CONF=self.conf), text=True, timeout=30, check=False)
        job = re.search(r"Submitted batch job (\d+)", answer.stdout)
        if not job:
            raise AssertionError("sbatch: " + answer.stdout)
        return job.group(1)

    def wait_for(self, job, seconds):
        self.until(lambda: job not in self.ask("squeue", "--noheader", "-o", "%F"), seconds, "job %s has not ended" % job)

    def logs(self):
        text = self.ask("sinfo") + self.ask("squeue")
        for name in ("slurmctld.log", "slurmd.log"):
            path = os.path.join(self.folder, name)
            if os.path.exists(path):
                with open(path, encoding="utf-8", errors="replace") as file:
                    text += "".join(file.readlines()[-15:])
        return text
