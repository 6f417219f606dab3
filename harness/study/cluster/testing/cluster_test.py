#!/usr/bin/env python3
"""mwt cluster on a real Slurm: with_slurm.sh 4 cluster_test.py MWT

A study of 500 runs in four shards. Of these, one is on a node that is killed, one is over its time limit, one is cancelled; after
`mwt cluster resubmit` the merged records must equal those of a single machine, apart from times."""

import csv
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

MWT = os.path.abspath(sys.argv.pop(1))
RIVALS = pathlib.Path(__file__).resolve().parents[4] / "library/examples/rivals"
PATIENCE_S = 900

STUDY = """
name = "five_hundred"
summary = "100 instances, 5 algorithms"
families = ["uniform", "clustered"]
sizes = [20, 30, 40, 50, 60]
seeds = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]
algorithms = ["delaunay", "greedy", "flip", "sweep", { name = "slow", command = ["./slow.sh"] }]
min_time_s = 0.0001
"""

# How long it sleeps is in a file, for all or for one shard: outside Slurm it does not sleep.
SLOW = f"""#!/bin/sh
here=$(dirname "$0")
sleep "$(cat "$here/seconds.${{SLURM_ARRAY_TASK_ID-none}}" 2>/dev/null || echo 0)"
exec {RIVALS}/fan_sweep.sh
"""

# Times, and what names the machine or the moment.
NOT_COMPARED = {
    "env_id", "recorded_at", "wall_time_s", "cpu_time_s", "iterations", "peak_rss_bytes", "phases", "delaunay_time_s",
    "optimum_time_s", "verify_time_s",
}


def rows(folder, name):
    """Without times; some counters are times, too."""
    with open(pathlib.Path(folder) / name, newline="") as file:
        table = [{key: value for key, value in row.items() if key not in NOT_COMPARED} for row in csv.DictReader(file)]
    for row in table:
        if "counters" in row:
            row["counters"] = [item for item in row["counters"].split() if not item.split("=")[0].endswith("_s")]
    return table


class Cluster(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory(prefix="mwt_cluster_")
        self.addCleanup(self.temporary.cleanup)
        self.folder = pathlib.Path(self.temporary.name)
        self.out = self.folder / "on cluster"  # a blank, as in the names of many home directories
        self.environment = dict(os.environ, COLUMNS="80", MWT_CACHE_DIR=str(self.folder / "cluster_optima"))
        (self.folder / "five_hundred.toml").write_text(STUDY)
        slow = self.folder / "slow.sh"
        slow.write_text(SLOW)
        slow.chmod(0o755)

    def mwt(self, *arguments, code=0, environment=None):
        done = subprocess.run([MWT, *map(str, arguments)], cwd=self.folder, env=environment or self.environment,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True)
        self.assertEqual(done.returncode, code, f"{arguments}: {done.stdout}{done.stderr}")
        return done.stderr if code == 2 else done.stdout

    def slurm(self, *words):
        return subprocess.run(words, check=True, capture_output=True, text=True).stdout

    def sleep_of_shard(self, shard, seconds):
        (self.folder / f"seconds.{shard}").write_text(str(seconds))

    def status(self):
        text = self.mwt("cluster", "status", self.out)
        for line in text.splitlines():
            if str(self.out) not in line:  # commands stay whole
                self.assertLessEqual(len(line), 80, text)
        return text

    def shard(self, number):
        """The fields of a shard in the status: number, state, optima, runs, the rest."""
        for line in self.status().splitlines():
            fields = line.split(maxsplit=4)
            if fields and fields[0] == str(number):
                return fields + [""] * (5 - len(fields))
        return None

    def wait_until(self, what, condition):
        begin = time.monotonic()
        while not condition():
            if time.monotonic() - begin > PATIENCE_S:
                logs = "".join(f"\n{log}:\n{log.read_text()}" for log in sorted((self.out / "logs").glob("*.log")))
                self.fail(f"in vain waited for: {what}\n{self.status()}{self.slurm('squeue', '-a', '-r')}{logs}")
            time.sleep(1)

    def runs_of(self, number):
        return int(self.shard(number)[3].split("/")[0])

    def is_running_with(self, number, runs):
        fields = self.shard(number)
        return fields[1] == "running" and int(fields[3].split("/")[0]) >= runs

    def kill_node(self, node):
        """Everything of that node dies at once: its daemon, the managers of its jobs, and these."""
        doomed = set()
        for process in pathlib.Path("/proc").iterdir():
            try:
                words = (process / "cmdline").read_bytes().split(b"\0")
                environment = (process / "environ").read_bytes().split(b"\0")
                parent = int((process / "stat").read_text().rsplit(")", 1)[1].split()[1])
            except (OSError, ValueError):
                continue
            if b"slurmd" in words[0] and node.encode() in words:
                doomed.add(int(process.name))
            if f"SLURMD_NODENAME={node}".encode() in environment:
                doomed.add(int(process.name))
                if b"slurmstepd" in (pathlib.Path("/proc") / str(parent) / "cmdline").read_bytes():
                    doomed.add(parent)
        self.assertGreater(len(doomed), 2)
        for process in sorted(doomed):  # the older ones first
            try:
                os.kill(process, signal.SIGKILL)
            except ProcessLookupError:
                pass

    def expect_records_of_one_machine(self, merged, single):
        for name in ("runs.csv", "instances.csv"):
            ours, theirs = rows(merged, name), rows(single, name)
            self.assertEqual(len(ours), len(theirs), name)
            for mine, other in zip(ours, theirs):
                self.assertEqual(mine, other)

    def run_on_one_machine(self):
        single = self.folder / "single"
        self.mwt("run", "five_hundred.toml", "--out", single,
                 environment=dict(self.environment, MWT_CACHE_DIR=str(self.folder / "own_optima")))
        self.assertEqual(len(rows(single, "runs.csv")), 500)
        return single

    def test_killed_node_time_limit_and_cancelled_task(self):
        single = self.run_on_one_machine()
        for shard, seconds in {1: 0.3, 2: 3, 3: 1.5, 4: 1.5}.items():
            self.sleep_of_shard(shard, seconds)
        print(self.mwt("cluster", "submit", "five_hundred.toml", "--shards", 4, "--time", 2, "--mem", "2G", "--out", self.out))
        jobs = {row["kind"]: row["job_id"] for row in rows(self.out, "jobs.csv")}
        self.wait_until("shards 3 and 4 running", lambda: self.is_running_with(3, 10) and self.is_running_with(4, 10))
        print(self.status())
        node = self.slurm("squeue", "--noheader", f"--jobs={jobs['runs']}_3", "--format=%N").strip()
        self.kill_node(node)
        self.slurm("scancel", f"{jobs['runs']}_4")
        self.wait_until("the cancelled task to be reported", lambda: self.shard(4)[1] == "failed")
        self.assertIn("cancelled", self.shard(4)[4])
        recorded = self.runs_of(4)
        self.assertTrue(10 <= recorded < 125, recorded)
        print(self.status())
        self.wait_until("the other shards", lambda: all(self.shard(number)[1] == "done" for number in (1, 2, 3)))
        self.wait_until("the merging job to find the gap", lambda: "merging: refused, for runs are missing" in self.status())
        print(self.status())
        self.assertIn("stopped before the time limit; queued again", (self.out / "logs/runs-2.log").read_text())
        self.assertGreaterEqual(len(list((self.out / "shards/3").iterdir())), 3, "optima, runs, runs again")

        self.sleep_of_shard(4, 0)
        self.sleep_of_shard(2, 0)
        print(self.mwt("cluster", "resubmit", self.out))
        last = rows(self.out, "jobs.csv")[-2:]
        self.assertEqual([(row["kind"], row["shards"]) for row in last], [("runs", "4"), ("merge", "")])
        self.wait_until("the report", lambda: (self.out / "merged/tables.txt").exists())
        print(self.status())
        self.expect_records_of_one_machine(self.out / "merged", single)
        self.assertIn("nothing is missing", self.mwt("cluster", "resubmit", self.out))

    def test_cancel_and_resubmit(self):
        for shard in (1, 2):
            self.sleep_of_shard(shard, 1)
        self.mwt("cluster", "submit", "five_hundred.toml", "--shards", 2, "--out", self.out)
        self.wait_until("a shard to run", lambda: self.is_running_with(1, 1))
        self.assertIn("nothing to submit", self.mwt("cluster", "resubmit", self.out))
        self.assertIn("cancelled: jobs", self.mwt("cluster", "cancel", self.out))
        self.wait_until("an empty queue", lambda: not self.slurm("squeue", "--noheader").strip())
        self.assertIn("nothing waits or runs", self.mwt("cluster", "cancel", self.out))
        self.assertEqual(self.shard(1)[1], "failed")
        self.assertFalse([row for row in rows(self.newest_attempt(1), "runs.csv") if row["status"] != "ok"],
                         "a run that the signal ended is no row")
        for shard in (1, 2):
            self.sleep_of_shard(shard, 0)
        self.mwt("cluster", "resubmit", self.out, "--time", 30)
        self.wait_until("the report", lambda: (self.out / "merged/tables.txt").exists())
        self.assertEqual(len(rows(self.out / "merged", "runs.csv")), 500)

    def test_a_preempted_task_goes_on(self):
        for shard in (1, 2):
            self.sleep_of_shard(shard, 1)
        self.mwt("cluster", "submit", "five_hundred.toml", "--shards", 2, "--out", self.out)
        runs = rows(self.out, "jobs.csv")[1]["job_id"]
        self.wait_until("a shard to run", lambda: self.is_running_with(1, 3))
        node = self.slurm("squeue", "--noheader", f"--jobs={runs}_1", "--format=%N").strip()
        self.slurm("sbatch", "--partition=urgent", f"--nodelist={node}", "--output=/dev/null", "--wrap=sleep 3")
        self.wait_until("it to be preempted", lambda: "preempt" in (self.out / "logs/runs-1.log").read_text().lower())
        for shard in (1, 2):
            self.sleep_of_shard(shard, 0)
        self.wait_until("the report", lambda: (self.out / "merged/tables.txt").exists())
        self.assertEqual({row["status"] for row in rows(self.out / "merged", "runs.csv")}, {"ok"})
        self.assertEqual(self.newest_attempt(1).name, "attempt-3", "optima, runs, runs again")

    def newest_attempt(self, shard):
        return max((self.out / "shards" / str(shard)).iterdir(), key=lambda path: int(path.name.split("-")[1]))

    def test_refusals_of_slurm_leave_nothing(self):
        message = self.mwt("cluster", "submit", "five_hundred.toml", "--shards", 2, "--partition", "none", "--out", self.out, code=2)
        self.assertIn("invalid partition", message)
        self.assertEqual(message.count("\n"), 1, message)
        self.assertFalse(self.out.exists())
        self.assertFalse(self.slurm("squeue", "--noheader").strip())


if __name__ == "__main__":
    unittest.main(verbosity=2)
