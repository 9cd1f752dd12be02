#!/usr/bin/env python3
"""directions.py: whether the sources of each floor include no more than what stands below it, the upper floor's
targets name their sources, and the exported scenario library's headers show no type of another library."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# A floor: where it lies, and the floors that it may use besides itself.
FLOORS = {
    "interface": ("interface", []),
    "text": ("interface/text", ["interface"]),
    "check": ("interface/check", ["interface"]),
    "mbs": ("mbs", ["interface", "text"]),
    "functions": ("mbs/functions", ["interface", "text", "mbs"]),
    "mbs_subsystem": ("mbs/subsystem", ["interface", "mbs"]),
    "engine": ("engine_sub", ["interface", "text"]),
    "engine_subsystem": ("engine_sub/subsystem", ["interface", "engine"]),
    "transports": ("transports", ["interface"]),
    "sources": ("scenarios/sources",
                ["interface", "text", "transports", "mbs", "functions", "mbs_subsystem", "engine", "engine_subsystem"]),
    "output": ("scenarios/output", ["interface"]),
    "exported": ("scenarios/exported", ["interface", "text", "transports", "mbs", "mbs_subsystem", "engine", "sources", "scenario"]),
    "ssp": ("scenarios/ssp", ["interface", "text", "transports"]),
    "export": ("scenarios/export", ["interface", "text", "transports", "output", "sources", "exported", "scenario"]),
    "scenario": ("scenarios/scenario",
                 ["interface", "text", "transports", "output", "sources", "ssp", "mbs_subsystem", "engine_subsystem"]),
    "charts": ("scenarios/charts", ["interface", "text", "output"]),
    "identification": ("scenarios/identification", ["interface", "transports"]),
    "stability": ("scenarios/stability", ["interface", "text", "transports", "scenario", "identification"]),
    "study": ("scenarios/study", ["interface", "text", "transports", "output", "scenario", "charts", "identification",
                                  "stability"]),
    "advice": ("scenarios/advice", ["interface", "text", "transports", "output", "scenario", "identification", "charts", "stability",
                                    "study"]),
    "models": ("scenarios/models",
               ["interface", "text", "transports", "mbs", "mbs_subsystem", "engine", "engine_subsystem", "sources",
                "output", "scenario", "study"]),
    "view": ("scenarios/view",
             ["interface", "text", "transports", "mbs", "sources", "output", "scenario", "models"]),
    "command": ("scenarios/command", None),  # all
}
LISTED = ["output", "ssp", "exported", "export", "scenario", "charts", "identification", "stability", "study", "advice", "models", "view", "command", "sources"]


def floor_of(file):
    """The floor with the longest folder that holds it; None: none."""
    holding = [(len(folder), name) for name, (folder, _) in FLOORS.items()
               if file.is_relative_to(ROOT / folder)]
    return max(holding)[1] if holding else None


def sources():
    for top in ("interface", "mbs", "engine_sub", "transports", "scenarios"):
        for file in sorted((ROOT / top).rglob("*")):
            if file.suffix in (".cpp", ".hpp", ".h", ".c") and floor_of(file):
                yield file


def headers(files):
    """By what an include may say the floors that have such a header."""
    known = {}
    for file in files:
        if file.suffix not in (".hpp", ".h"):
            continue
        parts = file.relative_to(ROOT).parts
        for k in range(1, len(parts)):
            known.setdefault("/".join(parts[k:]), set()).add(floor_of(file))
    return known


def wrong_includes(files):
    known = headers(files)
    for file in files:
        floor = floor_of(file)
        allowed = FLOORS[floor][1]
        for name in re.findall(r'^#include "([^"]+)"', file.read_text(), re.M):
            owners = known.get(name, set())
            if allowed is not None and owners and not owners & {floor, *allowed}:
                yield f"{file.relative_to(ROOT)} includes {name} of {', '.join(sorted(owners))}; " \
                      f"{floor} may use {', '.join(allowed)}"


def unlisted(files):
    for floor in LISTED:
        folder = ROOT / FLOORS[floor][0]
        text = (folder / "CMakeLists.txt").read_text()
        if "GLOB" in text:
            yield f"{folder.relative_to(ROOT)}/CMakeLists.txt globs; allowed are lists of sources"
        for file in files:
            if file.suffix == ".cpp" and floor_of(file) == floor and str(file.relative_to(folder)) not in text:
                yield f"{file.relative_to(ROOT)} is in no target"


def foreign_types():
    """Headers of the exported scenario library that reach one of another library."""
    folder = ROOT / "scenarios/scenario"
    roots = [folder / "include", *(ROOT / top / "include" for top in ("interface", "interface/text", "transports"))]
    exported = re.findall(r"include/(tandem/\S+\.hpp)", (folder / "CMakeLists.txt").read_text())

    def reached(name, seen):
        file = next((root / name for root in roots if (root / name).exists()), None)
        if file and name not in seen:
            seen.add(name)
            for inner in re.findall(r'^#include [<"]([^>"]+)[>"]', file.read_text(), re.M):
                yield inner
                yield from reached(inner, seen)

    for name in exported:
        for inner in reached(name, set()):
            if inner.split("/")[0] in ("toml++", "fmt", "nlohmann", "boost", "Eigen", "spdlog", "muParser.h"):
                yield f"{name} of the exported scenario library reaches {inner}"


def main():
    files = list(sources())
    wrong = [*wrong_includes(files), *unlisted(files), *foreign_types()]
    print(*wrong, sep="\n") if wrong else print(f"{len(files)} files")
    return bool(wrong) or len(files) < 400


if __name__ == "__main__":
    sys.exit(main())
