#!/usr/bin/env python3
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Runs FMUs of Co-Simulation by tandem, by FMPy (where it can be imported) and by fmusim (where it is in PATH), on constant
inputs with the same steps, and prints the largest difference: `against_others.py TANDEM FMU...`. The exit status is 1
where tandem fails, or differs by more than 1e-12 of an output's largest value."""
import csv
import os
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
import zipfile

try:
    import fmpy
except ImportError:
    fmpy = None

MOST_STEPS = 5000
LIMIT = 1e-12


class Failed(Exception):
    pass


def command(words):
    run = subprocess.run(words, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise Failed((run.stderr.strip() or run.stdout.strip() or f"status {run.returncode}").splitlines()[0])
    return run.stdout


def rows(file):
    """The last row of each time, by time."""
    with open(file, encoding="utf-8") as lines:
        return {round(float(row["time"]), 9): row for row in csv.DictReader(line for line in lines if line[0] != "#")}


def of_tandem(tandem, fmu, step, stop, folder):
    with open(f"{folder}/s.toml", "w", encoding="utf-8") as out:
        out.write(f'[subsystems.x]\nsource = "fmu:{fmu}?type=cs&step={step!r}"\n[span]\nstop = {stop!r}\n')
    command([tandem, "--quiet", "run", f"{folder}/s.toml", "--output", f"{folder}/r"])
    return {t: {name.removeprefix("x."): value for name, value in row.items()}
            for t, row in rows(f"{folder}/r/results.csv").items()}


def of_fmpy(fmu, step, stop, events):
    try:
        found = fmpy.simulate_fmu(fmu, fmi_type="CoSimulation", start_time=0.0, stop_time=stop, output_interval=step,
                                  use_event_mode=events, early_return_allowed=events, validate=False)
    except Exception as error:  # of any kind
        raise Failed(str(error).splitlines()[0]) from error
    all_rows = {}
    for row in found:
        values = all_rows[round(float(row["time"]), 9)] = {}
        for name in found.dtype.names[1:]:
            if found[name].ndim == 1:
                values[name] = row[name]
            else:
                values.update((f"{name}[{k}]", one) for k, one in enumerate(row[name].flat))
    return all_rows


def of_fmusim(fmu, step, stop, events, folder):
    words = ["fmusim", "--interface-type", "cs", "--output-interval", repr(step), "--stop-time", repr(stop), "--output-file",
             f"{folder}/o.csv"]
    command(words + (["--event-mode-used", "--early-return-allowed"] if events else []) + [fmu])
    found = rows(f"{folder}/o.csv")
    for row in found.values():
        for name in [name for name, value in row.items() if " " in value.strip()]:
            row.update((f"{name}[{k}]", one) for k, one in enumerate(row.pop(name).split()))
    return found


def difference(ours, theirs):
    """The largest one of numbers that both have at times that both have, of an output's largest value, and their count."""
    worst, count = 0.0, 0
    both = sorted(ours.keys() & theirs.keys())
    names = set(ours[both[0]]) & set(theirs[both[0]]) - {"time"}
    for name in names:
        scale = max([1.0] + [abs(float(theirs[t][name])) for t in both])
        for t in both:
            worst, count = max(worst, abs(float(ours[t][name]) - float(theirs[t][name])) / scale), count + 1
    return worst, count


def stop_time(fmu, step):
    """That of its default experiment, or 10 steps; in whole steps."""
    with zipfile.ZipFile(fmu) as archive:
        experiment = xml.etree.ElementTree.fromstring(archive.read("modelDescription.xml")).find("DefaultExperiment")
    stop = None if experiment is None else experiment.get("stopTime")
    return step * min(MOST_STEPS, round(float(stop) / step) if stop else 10)


def told(tandem, fmu):
    """The own step that tandem takes, 1 s where the FMU names none, and whether the FMU is run with events."""
    for more in ("", "&step=1"):
        run = subprocess.run([tandem, "info", f"fmu:{fmu}?type=cs{more}"], capture_output=True, text=True, check=False)
        if run.returncode == 0 and "own step: none" not in run.stdout:
            step = float(run.stdout.split("own step: ")[1].split()[0])
            return step, "stops where its outputs jump" in run.stdout
    return None, run.stderr.strip() or "names no step"


def compare(tandem, fmu):
    step, events = told(tandem, fmu)
    if step is None:
        return f"is refused: {events}", True
    sentences, good = [], True
    with tempfile.TemporaryDirectory() as folder:
        try:
            ours = of_tandem(tandem, fmu, step, stop := stop_time(fmu, step), folder)
        except Failed as why:
            return f"fails: {why}", False
        others = {"FMPy": lambda: of_fmpy(fmu, step, stop, events)} if fmpy else {}
        if shutil.which("fmusim"):
            others["fmusim"] = lambda: of_fmusim(fmu, step, stop, events, folder)
        for name, run in others.items():
            try:
                worst, count = difference(ours, run())
                good = good and worst <= LIMIT
                sentences.append(f"{name} {worst:.2g} in {count} values")
            except Failed as why:
                sentences.append(f"{name} fails ({why})")
    return "; ".join(sentences) or f"{len(ours)} rows, compared with nobody", good


def main():
    tandem, fmus = sys.argv[1], sys.argv[2:]
    good = True
    for fmu in fmus:
        sentence, fine = compare(tandem, fmu)
        good = good and fine
        print(f"{'' if fine else 'DIFFERS '}{os.path.basename(fmu)}: {sentence}", flush=True)
    sys.exit(0 if good else 1)


main()
