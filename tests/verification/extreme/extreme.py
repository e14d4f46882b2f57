#!/usr/bin/env python3
"""Runs rows of the stiff and extreme matrix: every one alone, a theme, or all.

    extreme.py -R N83             rows whose identifier matches
    extreme.py -theme walls       a theme; -list names rows and themes
    extreme.py -full              the long forms too, as the report has them
    extreme.py -records FILE      writes what happened as JSON

The programs are those of CONTINUA_BIN, by default build/bin. Exit code 1 if a row fails.
"""
import argparse
import importlib
import json
import os
import re
import subprocess
import sys

os.environ.setdefault("OMP_NUM_THREADS", "1")
import bench  # noqa: E402
from cases import ROOT  # noqa: E402

THEMES = ("reynolds", "kernels", "units", "shapes", "data", "timeSteps", "transients", "longRuns", "failures",
          "matrices", "references")


def rows():
    for theme in THEMES:
        importlib.import_module(theme)
    names = [entry.id for entry in bench.ROWS]
    assert len(set(names)) == len(names), "identifiers are unique"
    return bench.ROWS


def show(record):
    margin = f", margin {bench.short(record['margin'])}" if record["margin"] is not None else ""
    print(f"{record['id']:6} {'FAILED' if record['failed'] else 'ok'}{margin}, {record['cpu']:.1f} s: "
          f"{record['case']}, {record['setting']}")
    for line in record["happened"]:
        print(f"       {line}")
    sys.stdout.flush()


def commit():
    """What the sources are at the time of a run, e.g. "1a2b3c4 and changes"."""
    def said(*command):
        try:
            return subprocess.run(("git", *command), cwd=ROOT, capture_output=True, text=True, check=False).stdout.strip()
        except OSError:
            return ""

    name = said("rev-parse", "--short", "HEAD") or "unknown"
    return name + (" and changes" if said("status", "--porcelain", "--untracked-files=no", "--", ".", ":(exclude)docs") else "")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-R", metavar="REGEX", help="rows whose identifier matches")
    parser.add_argument("-theme", choices=THEMES, action="append", help="rows of a theme")
    parser.add_argument("-full", action="store_true", help="long forms, and rows that have no other")
    parser.add_argument("-slow", action="store_true", help="only rows whose form is long")
    parser.add_argument("-list", action="store_true", help="list the rows and stop")
    parser.add_argument("-records", metavar="FILE", help="write the records as JSON")
    options = parser.parse_args()
    chosen = [entry for entry in rows()
              if (not options.R or re.fullmatch(options.R, entry.id)) and (not options.theme
                                                                           or entry.theme in options.theme)
              and (entry.slow or not options.slow) and (not entry.slow or options.full or options.slow or options.R)]
    if options.list:
        for entry in chosen:
            print(f"{entry.theme:10} {entry.id:6} {entry.case}, {entry.setting}")
        return 0
    if not chosen:
        parser.error("no such row")
    records, sources = [], commit()
    if options.records:
        os.makedirs(os.path.dirname(os.path.abspath(options.records)), exist_ok=True)
    for entry in chosen:
        records.append({**bench.measure(entry, options.full or options.slow), "commit": sources})
        show(records[-1])
        if options.records:
            with open(options.records, "w", encoding="utf-8") as file:
                json.dump(records, file, indent=1, ensure_ascii=False)
    failed = [record["id"] for record in records if record["failed"]]
    print(f"{len(records)} rows, {sum(record['cpu'] for record in records):.0f} s of processor time, "
          f"{len(failed)} failed{': ' + ' '.join(failed) if failed else ''}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
