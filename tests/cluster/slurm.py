"""Runs Slurm on this machine alone, without systemd or a database: `cluster` starts and stops munged, slurmctld and
slurmd. Needs root, Debian's munge, slurmctld, slurmd and slurm-client, and a machine without its own Slurm, because clients
read only /etc/slurm/slurm.conf."""

import contextlib
import os
import pathlib
import shutil
import socket
import subprocess
import time

CONFIGURATION = pathlib.Path("/etc/slurm/slurm.conf")
TEXT = """ClusterName=gabor
SlurmctldHost={host}
SlurmUser=root
AuthType=auth/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0
MinJobAge=3600
ReturnToService=2
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
NodeName={host} CPUs={cores} RealMemory=4000 State=UNKNOWN
PartitionName=farm Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def missing():
    """Returns the reason why Slurm cannot run here, or an empty string."""
    if os.getuid() != 0:
        return "needs root"
    if absent := [name for name in ("munged", "slurmctld", "slurmd", "squeue") if not shutil.which(name)]:
        return f"needs {', '.join(absent)}"
    if CONFIGURATION.exists():
        return f"{CONFIGURATION} already exists"
    return ""


@contextlib.contextmanager
def cluster(folder, cores=2):
    """Runs a queue with one node and this number of cores."""
    host = socket.gethostname().split(".")[0]
    for name in ("state", "spool"):
        (folder / name).mkdir(parents=True)
    with contextlib.ExitStack() as stack:
        def daemon(*command):
            log = stack.enter_context(open(folder / f"{command[0]}.log", "w"))
            process = subprocess.Popen(command, stdout=log, stderr=log, stdin=subprocess.DEVNULL)
            stack.callback(process.wait, 30)
            stack.callback(process.terminate)

        os.makedirs("/run/munge", exist_ok=True)
        shutil.chown("/run/munge", "munge", "munge")
        daemon("runuser", "-u", "munge", "--", "munged", "--foreground")
        CONFIGURATION.write_text(TEXT.format(host=host, folder=folder, cores=cores))
        stack.callback(CONFIGURATION.unlink)
        daemon("slurmctld", "-D")
        daemon("slurmd", "-D")
        wait_for(lambda: "idle" in output("sinfo", "--noheader", "--format=%T"), 60)
        yield
        if left := jobs():
            subprocess.run(["scancel", "--full", *left], check=True)
        wait_for(lambda: not jobs(), 60)


def output(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout


def jobs(*states):
    """Returns the numbers of the jobs in these states, by default all jobs in the queue."""
    return output("squeue", "--noheader", "--format=%i", *(["--states=" + ",".join(states)] if states else [])).split()


def wait_for(condition, seconds):
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise TimeoutError(f"still waiting after {seconds} s")
        time.sleep(0.2)
