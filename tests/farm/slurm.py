#!/usr/bin/env python3
"""Slurm on one node: tasks are killed, preempted and requeued in the middle, and the merged image has the bits of one run.

    tests/farm/slurm.py [--program build/eikonal]

Needs Debian's slurm-wlm and munge, and root; skipped without them. Starts the daemons in a folder of its own, on free ports, and ends them.
"""

import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import tempfile
import time

from farm_test import SCENE, expect, pixels_of, program, run, scratch, skip, wait_until


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class Cluster:
    """A controller and a node on this machine."""

    def __init__(self, folder):
        self.folder, self.daemons = folder, []
        host = socket.gethostname().split(".")[0]
        for name in ("state", "spool"):
            (folder / name).mkdir()
        self.conf = folder / "slurm.conf"
        self.conf.write_text(
            f"""ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={free_port()}
SlurmdPort={free_port()}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
KillWait=10
RequeueExit=137
SchedulerParameters=sched_interval=2,batch_sched_delay=1
NodeName={host} NodeAddr=127.0.0.1 CPUs={os.cpu_count()} State=UNKNOWN
PartitionName=main Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""
        )
        key = folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        folder.chmod(0o755)
        os.environ["SLURM_CONF"] = str(self.conf)

    def __enter__(self):
        try:
            self.start()
        except BaseException:
            self.__exit__()
            raise
        return self

    def start(self):
        f = self.folder
        self.daemon("munged", "--foreground", f"--key-file={f}/munge.key", f"--socket={f}/munge.socket", f"--pid-file={f}/munged.pid",
                    f"--log-file={f}/munged.log", f"--seed-file={f}/munged.seed", "--force")
        wait_until((f / "munge.socket").exists, "munged listens", 30)
        self.daemon("slurmctld", "-D", "-f", self.conf)
        self.daemon("slurmd", "-D", "-f", self.conf)
        wait_until(lambda: "idle" in run("sinfo", "-h", "-o", "%T", status=None), "the node is idle", 60)

    def daemon(self, *words):
        """Starts a process that ends with this one, however that ends."""
        words = ["setpriv", "--pdeathsig", "TERM", *map(str, words)]
        with open(self.folder / "daemons.log", "a") as log:
            self.daemons.append(subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=log, stderr=log))

    def __exit__(self, *_):
        run("scancel", "--user=root", status=None)
        deadline = time.monotonic() + 20
        while self.jobs() and time.monotonic() < deadline:
            time.sleep(0.2)
        for daemon in reversed(self.daemons):
            daemon.terminate()
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def jobs(self):
        return run("squeue", "-h", "-r", "-o", "%i %T", status=None).splitlines()

    def state(self, job):
        return next((line.split()[1] for line in self.jobs() if line.split()[0] == str(job)), "")

    def start_again(self, job):
        """Slurm would wait for two minutes before it starts a job that was requeued."""
        wait_until(lambda: "Restarts=1" in run("scontrol", "show", "job", job) and self.state(job) == "PENDING", f"{job} is requeued", 60)
        run("scontrol", "update", f"JobId={job}", "StartTime=now")


def renderers(folder):
    """The processes that render parts of the job in `folder`."""
    found = []
    for entry in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            words = (entry / "cmdline").read_bytes().split(b"\0")
            if len(words) > 1 and words[1] in (b"render", b"compile-kernels") and os.readlink(entry / "cwd") == str(folder):
                found.append(int(entry.name))
        except OSError:
            pass
    return found


def parent_of(process):
    return int(pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[1])


class Job:
    def __init__(self, cluster, eikonal, folder, *options, **environment):
        self.cluster, self.folder = cluster, folder
        text = run(eikonal, "submit", SCENE, "--engine", "slurm", "--folder", folder, *options, env=os.environ | environment)
        found = re.search(r"parts: job (\d+); merge: job (\d+)", text)
        self.array, self.merge = found[1], found[2]

    def part(self, task):
        tile, samples = task // 2 + 1, task % 2 + 1
        return self.folder / "parts" / f"tile-{tile}-of-2-samples-{samples}-of-2.film"

    def until_it_renders(self, task):
        """The part runs and has a checkpoint, so there is something to go on from."""
        wait_until(lambda: self.cluster.state(f"{self.array}_{task}") == "RUNNING" and self.part(task).exists(), f"part {task} has a checkpoint")


def main():
    eikonal = program()
    missing = [name for name in ("munged", "slurmctld", "slurmd", "sbatch") if not shutil.which(name)]
    if missing or os.geteuid() != 0:
        skip(f"{', '.join(missing) or 'root'} missing: apt-get install slurm-wlm munge, and run as root")
    with scratch() as name, tempfile.TemporaryDirectory() as plain:  # no name of Slurm's may have a space
        top = pathlib.Path(name)
        settings = ["--spp", "8192", "--resolution", "64x64", "--checkpoint-every", "1s", "--aov", "depth"]
        parts = [*settings, "--tiles", "2", "--sample-ranges", "2"]
        with Cluster(pathlib.Path(plain)) as cluster:
            # Three of four parts are ended in the middle, each in another way
            job = Job(cluster, eikonal, top / "job", *parts, "-o", top / "image.exr", "-o", top / "all.film")
            job.until_it_renders(0)
            os.kill(renderers(job.folder)[0], signal.SIGKILL)
            print("part 0 is killed, as by a lack of memory; RequeueExit=137 puts it back", flush=True)
            job.until_it_renders(1)
            run("scontrol", "requeue", f"{job.array}_1")
            print("part 1 is killed and requeued by Slurm, as by preemption", flush=True)
            job.until_it_renders(2)
            os.kill(parent_of(renderers(job.folder)[0]), signal.SIGUSR1)
            print("part 2 is told that its time is nearly over", flush=True)
            for task in range(3):
                cluster.start_again(f"{job.array}_{task}")
            wait_until(lambda: not cluster.jobs(), "all parts and the merge are done", 600)
            log = job.folder / "log" / "merge.txt"
            log = log.read_text() if log.exists() else (cluster.folder / "daemons.log").read_text()
            expect("merged 4 parts" in log and (top / "image.exr").exists(), f"the merge ran after the parts: {log[-3000:]}")
            run(eikonal, "render", SCENE, *settings, "-o", top / "whole.film")
            expect(pixels_of(top / "all.film") == pixels_of(top / "whole.film"), "all sums have the bits of one run")

            # scancel, while rays are traced and while kernels compile
            slow = ["--spp", "1000000", *parts[2:]]
            job = Job(cluster, eikonal, top / "cancelled", *slow)
            job.until_it_renders(0)
            run("scancel", job.array, job.merge)
            seconds = wait_until(lambda: not cluster.jobs() and not renderers(job.folder), "the job is gone", 60)
            expect(seconds < 5, f"scancel takes {seconds:.1f} s while rays are traced")
            run(eikonal, "merge", job.part(0), "--partial", "-o", top / "partial.exr", status=4)
            job = Job(cluster, eikonal, top / "compiling", *slow, EIKONAL_CACHE_DIR=str(top / "empty"))
            log = job.folder / "log" / "part-0.txt"
            wait_until(lambda: log.exists() and "compiling" in log.read_text(), "kernels compile")
            run("scancel", job.array, job.merge)
            seconds = wait_until(lambda: not cluster.jobs() and not renderers(job.folder), "the job is gone", 60)
            expect(seconds < 5, f"scancel takes {seconds:.1f} s while kernels compile")


if __name__ == "__main__":
    main()
