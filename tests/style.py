#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the C++ sources: format (.clang-format), 100 columns, licence line. Exit code 1 and one
line for each place where that does not hold. Functions longer than 60 lines and files longer than
300 are listed, not refused: docs and review decide about these."""
import concurrent.futures
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("app", "engine", "ui", "tests")
MOST_COLUMNS, MOST_FUNCTION_LINES, MOST_FILE_LINES = 100, 60, 300


def sources():
    return sorted(p for folder in FOLDERS for p in (ROOT / folder).rglob("*")
                  if p.suffix in (".cpp", ".h"))


def format_problem(path):
    """First place where clang-format would change the file; None if there is none."""
    run = subprocess.run(["clang-format", "--dry-run", "--Werror", str(path)], cwd=ROOT,
                         capture_output=True, text=True)
    if run.returncode == 0:
        return None
    first = (run.stderr.splitlines() or ["clang-format failed"])[0]
    return re.sub(r"^\S*?:(\d+):\d+: error: .*", r"\1: not as clang-format -i would have it", first)


def functions(lines):
    """(first line, number of lines) of each definition of a formatted file: what begins in some
    column, ends its head with ") {" or the like, and closes in the same column."""
    head = re.compile(r"^(\s*)(?!namespace|extern|struct|class|enum|union|if|for|while|switch|else|do"
                      r"|case|return|try|catch)[\w:~<>\[\]].*")
    start = None
    for i, line in enumerate(lines):
        if start is None:
            if head.match(line) and not line.rstrip().endswith(";"):
                indent = line[: len(line) - len(line.lstrip())]
                if len(indent) > 2:
                    continue
                end_of_head = i
                while end_of_head < min(i + 12, len(lines)) and not re.search(
                        r"[;{}]\s*(//.*)?$", lines[end_of_head]):
                    end_of_head += 1
                if end_of_head < len(lines) and re.search(r"\)[\w\s&:>\-]*\{\s*$|\}\s*,?\s*\{\s*$",
                                                          lines[end_of_head]):
                    start = (i, indent)
        elif line.startswith(start[1] + "}"):
            yield start[0] + 1, i - start[0] + 1
            start = None


def main():
    files = sources()
    problems, long_places = [], []
    with concurrent.futures.ThreadPoolExecutor() as pool:
        for path, problem in zip(files, pool.map(format_problem, files)):
            if problem:
                problems.append(f"{path.relative_to(ROOT)}:{problem}")
    for path in files:
        name, lines = path.relative_to(ROOT), path.read_text(encoding="utf-8").splitlines()
        if not lines or "SPDX-License-Identifier: MIT" not in lines[0]:
            problems.append(f"{name}:1: the first line is not the licence's")
        for i, line in enumerate(lines):
            if len(line) > MOST_COLUMNS:
                problems.append(f"{name}:{i + 1}: {len(line)} columns, {MOST_COLUMNS} allowed")
        for first, count in functions(lines):
            if count > MOST_FUNCTION_LINES:
                long_places.append(f"{name}:{first}: function of {count} lines")
        if len(lines) > MOST_FILE_LINES:
            long_places.append(f"{name}: {len(lines)} lines")
    for place in long_places:
        print("long:", place)
    for problem in problems:
        print("style:", problem)
    print(f"style: {len(files)} files, {len(problems)} problems, {len(long_places)} long places")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
