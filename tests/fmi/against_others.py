#!/usr/bin/env python3
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Runs FMUs by tandem, by FMPy (where it can be imported) and by fmusim (where it is in PATH), on constant inputs, and prints
the largest difference: `against_others.py TANDEM FMU...`. Co-Simulation takes the same steps everywhere, Model Exchange is
integrated by CVODE with a relative tolerance of 1e-9. The exit status is 1 where tandem fails, or differs by more than
1e-12 (Model Exchange: 1e-6) of an output's largest value."""
import collections
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
KINDS = {"cs": "CoSimulation", "me": "ModelExchange"}
LIMITS = {"cs": 1e-12, "me": 1e-6}
TOLERANCE = 1e-9


class Failed(Exception):
    pass


def command(words):
    run = subprocess.run(words, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise Failed((run.stderr.strip() or run.stdout.strip() or f"status {run.returncode}").splitlines()[0])
    return run.stdout


def rows(file):
    """Those of each time, by time: at an event there are two, and some show the first alone."""
    found = collections.defaultdict(list)
    with open(file, encoding="utf-8") as lines:
        for row in csv.DictReader(line for line in lines if line[0] != "#"):
            found[round(float(row["time"]), 9)].append(row)
    return found


def of_tandem(tandem, fmu, kind, step, stop, folder):
    integrator = f"&integrator=cvode_bdf&relative_tolerance={TOLERANCE}" if kind == "me" else ""
    with open(f"{folder}/s.toml", "w", encoding="utf-8") as out:
        out.write(f'[subsystems.x]\nsource = "fmu:{fmu}?type={kind}&step={step!r}{integrator}"\n[span]\nstop = {stop!r}\n')
    command([tandem, "--quiet", "run", f"{folder}/s.toml", "--output", f"{folder}/r"])
    return {t: [{name.removeprefix("x."): value for name, value in row.items()} for row in of_time]
            for t, of_time in rows(f"{folder}/r/results.csv").items()}


def of_fmpy(fmu, kind, step, stop, events):
    try:
        found = fmpy.simulate_fmu(fmu, fmi_type=KINDS[kind], start_time=0.0, stop_time=stop, output_interval=step, solver="CVode",
                                  relative_tolerance=TOLERANCE if kind == "me" else None, use_event_mode=events,
                                  early_return_allowed=events, validate=False)
    except Exception as error:  # of any kind
        raise Failed(str(error).splitlines()[0]) from error
    all_rows = collections.defaultdict(list)
    for row in found:
        all_rows[round(float(row["time"]), 9)].append(values := {})
        for name in found.dtype.names[1:]:
            if found[name].ndim == 1:
                values[name] = row[name]
            else:
                values.update((f"{name}[{k}]", one) for k, one in enumerate(row[name].flat))
    return all_rows


def of_fmusim(fmu, kind, step, stop, events, folder):
    words = ["fmusim", "--interface-type", kind, "--output-interval", repr(step), "--stop-time", repr(stop), "--output-file",
             f"{folder}/o.csv"]
    if kind == "me":
        words += ["--solver", "cvode", "--tolerance", repr(TOLERANCE)]
    elif events:
        words += ["--event-mode-used", "--early-return-allowed"]
    command(words + [fmu])
    found = rows(f"{folder}/o.csv")
    for row in (one for of_time in found.values() for one in of_time):
        for name in [name for name, value in row.items() if " " in value.strip()]:
            row.update((f"{name}[{k}]", one) for k, one in enumerate(row.pop(name).split()))
    return found


def difference(ours, theirs):
    """The largest one of numbers that both have at times that both have, of an output's largest value, and their count."""
    worst, count = 0.0, 0
    both = sorted(ours.keys() & theirs.keys())
    names = set(ours[both[0]][0]) & set(theirs[both[0]][0]) - {"time"}
    for name in names:
        scale = max([1.0] + [abs(float(row[name])) for t in both for row in theirs[t]])
        for t in both:
            off = min(abs(float(one[name]) - float(other[name])) for one in ours[t] for other in theirs[t])
            worst, count = max(worst, off / scale), count + 1
    return worst, count


def description(fmu):
    with zipfile.ZipFile(fmu) as archive:
        return xml.etree.ElementTree.fromstring(archive.read("modelDescription.xml"))


def offered(fmu):
    """Of Co-Simulation and Model Exchange what the FMU offers; the former, which is refused then, where it is neither."""
    root = description(fmu)
    return [kind for kind, element in KINDS.items() if root.find(element) is not None] or ["cs"]


def experiment_stop(fmu):
    """0 where it has none."""
    experiment = description(fmu).find("DefaultExperiment")
    return float("0" if experiment is None else experiment.get("stopTime", "0"))


def stop_time(fmu, step):
    """That of its default experiment, or 10 steps; in whole steps."""
    return step * min(MOST_STEPS, round(experiment_stop(fmu) / step) or 10)


def told(tandem, fmu, kind, otherwise):
    """The own step that tandem takes, `otherwise` where the FMU names none, and whether the FMU is run with events."""
    for more in ("", f"&step={otherwise}"):
        run = subprocess.run([tandem, "info", f"fmu:{fmu}?type={kind}{more}"], capture_output=True, text=True, check=False)
        if run.returncode == 0 and "own step: none" not in run.stdout:
            step = float(run.stdout.split("own step: ")[1].split()[0])
            return step, "stops where its outputs jump" in run.stdout
    return None, run.stderr.strip() or "names no step"


def compare(tandem, fmu, kind, otherwise):
    step, events = told(tandem, fmu, kind, otherwise)
    if step is None:
        return f"is refused: {events}", True
    sentences, good = [], True
    with tempfile.TemporaryDirectory() as folder:
        try:
            ours = of_tandem(tandem, fmu, kind, step, stop := stop_time(fmu, step), folder)
        except Failed as why:
            if otherwise != 1.0 and "own time" in str(why):  # steps of another length
                return compare(tandem, fmu, kind, 1.0)
            return f"fails: {why}", False
        others = {"FMPy": lambda: of_fmpy(fmu, kind, step, stop, events)} if fmpy else {}
        if shutil.which("fmusim"):
            others["fmusim"] = lambda: of_fmusim(fmu, kind, step, stop, events, folder)
        for name, run in others.items():
            try:
                worst, count = difference(ours, run())
                good = good and worst <= LIMITS[kind]
                sentences.append(f"{name} {worst:.2g} in {count} values")
            except Failed as why:
                sentences.append(f"{name} fails ({why})")
    return "; ".join(sentences) or f"{len(ours)} rows, compared with nobody", good


def main():
    tandem, fmus = sys.argv[1], sys.argv[2:]
    good = True
    for fmu in fmus:
        for kind in offered(fmu):
            sentence, fine = compare(tandem, fmu, kind, experiment_stop(fmu) / 10 or 1.0)
            good = good and fine
            print(f"{'' if fine else 'DIFFERS '}{os.path.basename(fmu)}, {kind}: {sentence}", flush=True)
    sys.exit(0 if good else 1)


main()
