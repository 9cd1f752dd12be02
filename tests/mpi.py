#!/usr/bin/env python3
"""mpi.py TANDEM SCENARIOS: a sweep by the ranks of an MPI program has the bytes of one by threads; a rank that is killed
ends it with its rows kept, and --resume comes to the same bytes."""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1"}
TABLES = ("schemes.csv", "schemes.json")


class Sweeps:
    def __init__(self, program, scenarios, folder):
        self.words = [program, "--quiet", "sweep", str(scenarios / "motor_crank/study.toml")]
        self.folder = folder
        self.expected = {}

    def by_threads(self, name, *more):
        subprocess.run([*self.words, "--output", name, "--threads", "2", *more], cwd=self.folder, check=True)
        return self.tables(name)

    def by_ranks(self, ranks, name, *more):
        return subprocess.Popen(["mpirun", "-n", str(ranks), *self.words, "--output", name, *more], cwd=self.folder,
                                env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def tables(self, name):
        return [(self.folder / name / table).read_bytes() for table in TABLES]


def rank_of(process):
    text = pathlib.Path(f"/proc/{process}/environ").read_bytes()
    found = [word for word in text.split(b"\0") if word.startswith(b"OMPI_COMM_WORLD_RANK=")]
    return int(found[0].split(b"=")[1]) if found else None


def ranks_of(mpirun):
    """The process of each rank."""
    children = pathlib.Path(f"/proc/{mpirun.pid}/task/{mpirun.pid}/children").read_text().split()
    return {rank_of(child): int(child) for child in children}


def rows_in(part):
    return part.read_bytes().count(b"\n") - 1 if part.exists() else 0


def check(holds, sentence):
    if not holds:
        sys.exit(f"mpi: {sentence}")


def check_same_bytes(sweeps):
    expected = sweeps.by_threads("threads")
    for ranks in (1, 2, 3, 5, 8):
        sweep = sweeps.by_ranks(ranks, f"ranks{ranks}")
        _, said = sweep.communicate(timeout=300)
        check(sweep.returncode == 0, f"{ranks} ranks: status {sweep.returncode}: {said}")
        check(sweeps.tables(f"ranks{ranks}") == expected, f"{ranks} ranks wrote other bytes than threads")


def check_killed(sweeps, victim):
    long_runs = ("--set", "span.stop=40")  # so that there is time to kill one
    name = f"killed{victim}"
    sweep = sweeps.by_ranks(3, name, *long_runs)
    part = sweeps.folder / name / "schemes.part"
    for _ in range(3000):
        if rows_in(part) >= 3 or sweep.poll() is not None:
            break
        time.sleep(0.01)
    check(sweep.poll() is None, f"the sweep ended before rank {victim} was killed: {sweep.returncode}")
    os.kill(ranks_of(sweep)[victim], signal.SIGKILL)
    sweep.communicate(timeout=60)
    check(sweep.returncode != 0, "a sweep of which a rank was killed said ok")
    kept = rows_in(part)
    check(kept >= 3 and not (part.parent / TABLES[0]).exists(), f"{kept} rows are kept, or a table is there")
    resumed = sweeps.by_ranks(3, name, "--resume", *long_runs)
    _, said = resumed.communicate(timeout=300)
    check(resumed.returncode == 0, f"resumed: {said}")
    check(sweeps.tables(name) == sweeps.expected[long_runs], f"resumed after rank {victim}: other bytes")
    return kept


def check_wrong_study(sweeps):
    sweep = sweeps.by_ranks(3, "wrong", "--set", "span.stop=-1")
    _, said = sweep.communicate(timeout=60)
    check(sweep.returncode == 2 and "span" in said, f"a wrong study: status {sweep.returncode}: {said}")


def main():
    program, scenarios = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    folder = pathlib.Path(tempfile.mkdtemp())
    try:
        sweeps = Sweeps(str(program), scenarios, folder)
        check_same_bytes(sweeps)
        check_wrong_study(sweeps)
        sweeps.expected[("--set", "span.stop=40")] = sweeps.by_threads("long", "--set", "span.stop=40")
        for victim in (2, 0):
            print(f"rank {victim} was killed after {check_killed(sweeps, victim)} rows")
    finally:
        shutil.rmtree(folder)


if __name__ == "__main__":
    main()
