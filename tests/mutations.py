#!/usr/bin/env python3
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""mutations.py TANDEM FOLDER [RUNS [SEED]]: the project's own mechanisms, diagrams and scenarios, with numbers, names and
lines changed, through the commands that read and run them (default: 10 000 of them, seed 1). Each has to end in
minutes by a status that the command names, with a sentence where it is not 0, and where it is 0 without a nan in its
results. What does otherwise is left in FOLDER, and the status is 1."""

import pathlib
import random
import re
import shutil
import subprocess
import sys

SCENARIOS = pathlib.Path(__file__).resolve().parents[1] / "scenarios"
NUMBER = re.compile(r"(?<![\w.])-?\d+\.?\d*(?:[eE][-+]?\d+)?(?![\w.])")
NAME = re.compile(r'"[A-Za-z_][\w.]*"')
PACE = re.compile(r"step|stop|period|frequency|ratio|tolerance|cells|substeps")  # decides how long a run takes
LIMIT = 300  # [s]: to find no equilibrium of the kart in space takes half a minute


def other_number(chance, text, keeps_pace):
    x = float(text)
    near = [x * (1 + chance.gauss(0, 0.3)), x * (1 + chance.gauss(0, 0.03)), 2 * x, x / 2]
    far = [1e6 * x, 1e-6 * x, 1e8, 1e100, 1e300, 1e-300]
    odd = ["0", "-1", repr(-x), "nan", "inf"]
    return str(chance.choice(near + odd if keeps_pace else near + near + odd + far))


def mutated(chance, text):
    for _ in range(chance.choice((1, 1, 1, 2, 3))):
        lines = text.split("\n")
        at = chance.randrange(len(lines))
        line, kind = lines[at].partition("#")[0], chance.random()
        numbers, names = list(NUMBER.finditer(line)), list(NAME.finditer(line))
        if kind < 0.1:
            del lines[at]
        elif kind < 0.15:
            lines.insert(chance.randrange(len(lines)), line)
        elif kind < 0.35 and names:
            lines[at] = replaced(line, chance.choice(names), chance.choice(NAME.findall(text)))
        elif numbers:
            x = chance.choice(numbers)
            lines[at] = replaced(line, x, other_number(chance, x.group(), PACE.search(line)))
        text = "\n".join(lines)
    return text


def replaced(line, match, by):
    return line[:match.start()] + by + line[match.end():]


def commands(chance, text):
    """As scenario::kind_alone tells the kinds apart."""
    if re.search(r"^\[*blocks\b", text, re.MULTILINE):
        return [["info"], ["run", "--set", "run.stop=0.02"]]
    if not re.search(r"^dimension\b", text, re.MULTILINE):
        return [["info"], ["validate"], ["run", "--no-reference", "--set", "span.stop=0.02"]]
    formulation = chance.choice(("index3", "penalty", "index1", "null_space"))
    methods = ("newmark", "rk2", "rk4", "rk8", "generalized_alpha")
    integrator = "newmark" if formulation == "index3" else chance.choice(methods)
    by = ["--set", f"run.formulation={formulation}", "--set", f"run.integrator={integrator}"]
    return [["info"], ["modes"], ["run", "--set", "run.stop=0.02", *by]]


def fault(tandem, command, file, output):
    """What is wrong with how the command ends, or None."""
    words = [tandem, command[0], str(file), *command[1:], *(["--output", str(output)] if command[0] == "run" else [])]
    shutil.rmtree(output, ignore_errors=True)
    try:
        ended = subprocess.run(words, capture_output=True, timeout=LIMIT, text=True, errors="replace", cwd=file.parent)
    except subprocess.TimeoutExpired:
        return f"is not done after {LIMIT} s"
    if ended.returncode not in (0, 1, 2):
        return f"ends with status {ended.returncode}: {ended.stderr[-400:]}"
    if ended.returncode:
        return None if re.search("^tandem: (?!note: )", ended.stderr, re.MULTILINE) else f"says '{ended.stderr[:200]}'"
    results = "".join(file.read_text() for file in output.glob("results*.csv"))
    return "writes nan" if "nan" in results else None


def main(tandem, folder, runs=10000, seed=1):
    chance = random.Random(int(seed))
    scratch, wrong = pathlib.Path(folder).resolve(), 0
    shutil.rmtree(scratch, ignore_errors=True)
    shutil.copytree(SCENARIOS, scratch / "scenarios", ignore=shutil.ignore_patterns("src", "*.md", "*.png"))
    files = sorted((scratch / "scenarios").rglob("*.toml"))
    for number in range(int(runs)):
        file = chance.choice(files)
        text = file.read_text(encoding="utf-8")
        file.write_text(mutated(chance, text), encoding="utf-8")
        for command in commands(chance, text):
            if said := fault(str(pathlib.Path(tandem).resolve()), command, file, scratch / "output"):
                wrong += 1
                kept = shutil.copy(file, scratch / f"{number}_{file.name}")
                print(f"{kept}: tandem {' '.join(command)} {said}", flush=True)
        file.write_text(text, encoding="utf-8")
    print(f"{runs} files, seed {seed}: {wrong} wrong")
    return wrong > 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
